#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "record/append_file.h"
#include "record/classic_recorder.h"
#include "record/trace.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::record {

struct RecorderOptions {
  double frames_per_second = 4;  ///< of the classic view, at most 60
  std::string title, notes;
};

/// Records a simulation from its first tick on, into a new directory (DESIGN of it:
/// docs/recording-format.md). Everything is written as it happens: whatever ends the program, what
/// was complete stays readable.
class Recorder : public sim::Listener {
 public:
  /// @param eye  takes the pictures of the classic view; nullptr for text only. Must outlive this.
  /// @throws InputError if the directory exists and is not empty: a recording is never overwritten.
  /// @throws std::invalid_argument if the simulation has already begun or the rate is not in (0,
  /// 60].
  /// @throws std::runtime_error with path and reason if something cannot be written, as do all
  /// members.
  Recorder(const std::filesystem::path& directory, const RecorderOptions& options, sim::Eye* eye,
           const sim::Simulation& simulation);

  void OnCommand(const sim::Simulation& simulation, const sim::Command& command) override;
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;
  void OnTick(const sim::Simulation& simulation) override;

 private:
  AppendFile commands_;
  TraceWriter trace_;
  ClassicRecorder classic_;
};

}  // namespace smile::record
