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

/// Starts and finishes recordings of a running simulation by command, at any time.
///
/// A full disk, or a directory that is removed meanwhile, ends the recording, not the simulation:
/// see failure().
class RecordingController : public sim::Listener, public sim::RecordingControl {
 public:
  struct Options {
    std::filesystem::path root = "recordings";  ///< parent directory of recordings started by name
    RecorderOptions recording;                  ///< of all recordings; title and notes are defaults
    sim::Eye* eye = nullptr;                    ///< nullptr for no pictures
  };

  /// Attaches itself to a simulation.
  /// @param simulation  must outlive this, as must the eye.
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

  /// Starts a recording in exactly this directory. Throws like Recorder.
  void StartIn(const std::filesystem::path& directory, const sim::Simulation& simulation);
  /// Continues a recording, see Recorder::Continue(). Call before anything else is done.
  void Continue(const std::filesystem::path& directory, const recording::HistoryPoint& from,
                sim::Simulation* simulation, const recording::Progress& progress = {});
  /// Starts a recording that corrects another one: runs a fresh simulation as that was recorded, up
  /// to a moment from which others act. A robot stands still there.
  /// @param directory  of the new recording; empty for a new one under the root.
  /// @param seconds    from the start of the demonstration.
  /// @throws InputError if the recording has no such moment, or its replay differs;
  ///         std::runtime_error if `progress` returns false. Then no new recording is left.
  void Correct(const recording::Recording& recording, double seconds,
               const std::filesystem::path& directory, sim::Simulation* simulation,
               const recording::Progress& progress = {});

  /// Waits until everything recorded so far is written, also the pictures; an error ends the
  /// recording.
  void Flush();

  bool is_recording() const { return recorder_ != nullptr; }
  /// Returns the directories of all recordings that were started, in order.
  const std::vector<std::filesystem::path>& directories() const { return directories_; }
  /// Returns the reason why the last recording ended by itself or could not start, with the path.
  const std::optional<texts::UserMessage>& failure() const { return failure_; }

  std::optional<sim::Refusal> Refuse(const sim::Simulation& simulation,
                                     const sim::Command& command) override;
  void OnCommand(const sim::Simulation& simulation, const sim::Command& command) override;
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;
  void OnMove(const sim::Simulation& simulation, sim::ActionId from, sim::ActionId to) override;
  void OnTick(const sim::Simulation& simulation) override;

 private:
  void Start(const std::filesystem::path& directory, const RecorderOptions& options,
             const sim::Simulation& simulation);
  /// Calls `part` with the recorder, if any. If that fails, the recording ends with what was
  /// written.
  template <class Part>
  void Record(const Part& part);
  /// Calls `part`; if that throws, the recording ends, and nothing of it is left.
  template <class Part>
  void OrRemove(const std::filesystem::path& directory, const Part& part);
  /// Returns the reason why a scene cannot be loaded that lacks the camera of the eye.
  std::optional<sim::Refusal> RefuseWithoutCamera(const sim::Simulation& simulation,
                                                  const sim::Load& load) const;
  /// Ends the recording if its directory is missing: deleted files can still be written to, so no
  /// error would report it.
  void EndIfRemoved();

  Options options_;
  std::unique_ptr<Recorder> recorder_;
  std::vector<std::filesystem::path> directories_;
  std::optional<texts::UserMessage> failure_;
};

}  // namespace smile::recorder
