#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "editing/played_tracks.h"
#include "recorder/recording_controller.h"
#include "scene/bounds.h"
#include "scene/solid.h"
#include "sim/simulation.h"
#include "studio/capturing_eye.h"

namespace smile::studio {

/// Live world: a simulation with its recorder, its markers, and the messages about its events.
class LiveWorld : private sim::Listener {
 public:
  /// @throws std::invalid_argument if the scene lacks the camera of the recording eye.
  LiveWorld(scene::SceneSpec scene, std::optional<sim::RobotPlacement> robot,
            recorder::RecordingController::Options options);
  LiveWorld(const LiveWorld&) = delete;
  LiveWorld& operator=(const LiveWorld&) = delete;

  sim::Simulation& simulation() { return simulation_; }
  const sim::Simulation& simulation() const { return simulation_; }

  /// Applies a command, including `start` and `finish`; all commands pass here. A refusal is not an
  /// event.
  std::optional<sim::Refusal> Apply(const sim::Command& command);
  /// Continues a recording, see recorder::RecordingController::Continue(). To be called before
  /// anything else is done.
  void Continue(const recording::Recording& recording, const recording::HistoryPoint& from,
                const recording::Progress& progress);

  /// Records over a demonstration: starts a new recording where the demonstration began, and runs
  /// to the moment from which the user records, while the kept tracks act. To be called before
  /// anything else is done.
  /// @throws InputError; then no recording is left.
  void RecordOver(const recording::Recording& recording, const editing::KeptTracks& kept,
                  const recording::Progress& progress);
  /// Corrects a recording, see recorder::RecordingController::Correct(). To be called before
  /// anything else is done. What came before the moment cannot be undone.
  void Correct(const recording::Recording& recording, double seconds,
               const recording::Progress& progress);
  /// Advances by a tick.
  void Tick();

  /// Returns the eye of recordings; nullptr without one.
  CapturingEye* eye() { return eye_ ? &*eye_ : nullptr; }

  bool is_recording() const { return controller_.is_recording(); }
  /// Returns the directory of the last recording; empty before the first.
  std::filesystem::path recording_directory() const;
  /// Returns `recording` of a state message; null without one.
  Json DescribeRecording() const;
  /// Returns the recording that failed since the last call, as `failure` of a state message;
  /// nullopt without one. To be called often.
  std::optional<Json> TakeFailure();

  /// Returns the events since the last call, as messages.
  std::vector<Json> TakeEvents() { return std::exchange(events_, {}); }
  /// Returns the points that are marked for people [m].
  const std::vector<Vector3>& markers() const { return markers_; }
  /// Returns the bounds of each object in its own frame, over all variants of its controls; in
  /// scene order.
  const std::vector<scene::Bounds>& bounds() const { return bounds_; }
  /// Returns the pieces of each object, such as the walls of a box, in its frame.
  const std::vector<std::vector<scene::Solid>>& solids() const { return solids_; }

 private:
  struct Take {
    std::string title;
    sim::ActionId before;               ///< the last action before its start
    Json corrects;                      ///< `corrects` of a state message
    std::optional<sim::ActionId> kept;  ///< the last action that cannot be undone
    std::uint64_t start_tick = 0;
  };

  /// Undoes or redoes what the user did last, with what the played tracks did since.
  std::optional<sim::Refusal> ApplyToOwn(const sim::Command& command);
  /// Keeps what the played tracks did not find as it was, with the recording that has ended.
  void EndTracks();
  void RunToBegin(const recording::Progress& progress);
  /// Continues with a recording whose past has been repeated.
  void TakeUp(const recording::Recording& recording, const std::string& title);
  /// Updates bounds and markers when the model changes: another model has other objects; one of
  /// another scene also resets markers.
  void FollowModel();
  /// `segments` of DescribeRecording(), see docs/studio-protocol.md.
  Json DescribeSegments() const;

  void OnCommand(const sim::Simulation& simulation, const sim::Command& command) override;
  void OnMove(const sim::Simulation& simulation, sim::ActionId from, sim::ActionId to) override;
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;

  std::optional<CapturingEye> eye_;
  sim::Simulation simulation_;
  recorder::RecordingController controller_;
  std::string usual_title_;
  Take take_;                                    ///< that is recorded
  std::optional<editing::PlayedTracks> tracks_;  ///< over which it is recorded
  std::vector<Json> events_;
  std::string last_refusal_;
  bool is_applying_ = false;
  bool was_recording_ = false;  ///< when TakeFailure() was last called
  std::vector<Vector3> markers_;
  std::shared_ptr<const model::Model> bounded_;  ///< whose objects have the bounds
  std::shared_ptr<const model::Model> marked_;   ///< in whose scene the markers are
  std::vector<scene::Bounds> bounds_;
  std::vector<std::vector<scene::Solid>> solids_;
};

}  // namespace smile::studio
