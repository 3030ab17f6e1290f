#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recorder/recorder.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::recorder {

/// Starts and finishes recordings of a running simulation on command, at any time.
///
/// A disk that is full, or a directory that is removed meanwhile, ends the recording, not the
/// simulation: see failure().
class RecordingController : public sim::Listener, public sim::RecordingControl {
 public:
  struct Options {
    std::filesystem::path root = "recordings";  ///< where recordings go that are started by name
    RecorderOptions recording;                  ///< of all; title and notes of those without
    sim::Eye* eye = nullptr;                    ///< nullptr for no pictures
  };

  /// @param simulation  this listens to it from now on, and must outlive it, as the eye.
  RecordingController(sim::Simulation* simulation, Options options);
  RecordingController(const RecordingController&) = delete;
  RecordingController& operator=(const RecordingController&) = delete;

  /// Starts a recording in a new directory under the root; a number is added to its name if it is
  /// taken.
  std::optional<sim::Refusal> Start(const sim::Simulation& simulation,
                                    const sim::StartRecording& start) override;
  /// Ends the recording. Refuses, though the recording ends, if its directory is missing: then
  /// nothing is kept.
  std::optional<sim::Refusal> Finish(const sim::Simulation& simulation) override;

  /// Starts a recording in exactly this directory. Throws as Recorder does.
  void StartIn(const std::filesystem::path& directory, const sim::Simulation& simulation);
  /// Continues a recording, see Recorder::Continue(). To be called before anything else is done.
  void Continue(const std::filesystem::path& directory, const recording::HistoryPoint& from,
                sim::Simulation* simulation, const recording::Progress& progress = {});

  bool is_recording() const { return recorder_ != nullptr; }
  /// Returns the directories of all recordings that were started, in order.
  const std::vector<std::filesystem::path>& directories() const { return directories_; }
  /// Returns why the last recording ended by itself or could not start: path and reason.
  const std::optional<std::string>& failure() const { return failure_; }

  std::optional<sim::Refusal> Refuse(const sim::Simulation& simulation,
                                     const sim::Command& command) override;
  void OnCommand(const sim::Simulation& simulation, const sim::Command& command) override;
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;
  void OnMove(const sim::Simulation& simulation, sim::ActionId from, sim::ActionId to) override;
  void OnTick(const sim::Simulation& simulation) override;

 private:
  void Start(const std::filesystem::path& directory, const RecorderOptions& options,
             const sim::Simulation& simulation);
  /// Calls part with the recorder, if there is one. If that fails, what was written stays.
  template <class Part>
  void Record(const Part& part);
  /// A scene must have the camera of the eye.
  std::optional<sim::Refusal> RefuseWithoutCamera(const sim::Simulation& simulation,
                                                  const sim::Load& load) const;
  /// Ends the recording if its directory is missing: files that were removed can still be written
  /// to, so nothing else reports that.
  void EndIfRemoved();

  Options options_;
  std::unique_ptr<Recorder> recorder_;
  std::vector<std::filesystem::path> directories_;
  std::optional<std::string> failure_;
};

}  // namespace smile::recorder
