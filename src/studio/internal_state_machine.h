#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/json.h"
#include "studio/internal_restoring.h"
#include "studio/internal_session_state.h"
#include "studio/live_brain.h"
#include "studio/live_world.h"

namespace smile::studio {

/// Time control of a session.
struct Pace {
  bool is_paused = false;
  double speed_factor = 1;    ///< requested ratio of simulated to wall-clock time
  double measured_speed = 1;  ///< over the last second
};

/// State machine of a session: the states and the transitions between them, with the world and the
/// brain to which they refer.
///
/// The live world is always in one state: live, imitating or clearing the table (rage). Playback
/// may be shown in its place. Restoring runs in another thread, independent of both.
class StateMachine {
 public:
  class Listener {
   public:
    virtual ~Listener() = default;
    /// Called when the live world was replaced, or has another scene.
    virtual void OnOtherWorld() = 0;
    /// Called when another scene is shown.
    virtual void OnOtherScene() = 0;
    /// Called at the end of an imitation, with its score as a message for all clients.
    virtual void OnScore(Json score) = 0;
  };

  /// Requires Enter() before any other call. `listener` must outlive this.
  /// @param has_robot  true if worlds have a robot.
  StateMachine(bool has_robot, Listener* listener) : has_robot_(has_robot), listener_(listener) {}
  StateMachine(const StateMachine&) = delete;
  StateMachine& operator=(const StateMachine&) = delete;

  LiveWorld& world() { return *world_; }
  const LiveWorld& world() const { return *world_; }
  LiveBrain& brain() { return brain_; }
  const LiveBrain& brain() const { return brain_; }
  Pace& pace() { return pace_; }
  const Pace& pace() const { return pace_; }

  /// Returns the state that is shown.
  const SessionState& shown() const { return playback_ ? *playback_ : *world_state_; }
  /// Returns the playback; nullptr unless a recording is shown.
  PlaybackState* playback() { return playback_.get(); }
  const PlaybackState* playback() const { return playback_.get(); }
  /// Returns nullptr unless a recording is being continued from a point of its history.
  const Restoring* restoring() const { return restoring_.get(); }
  /// Returns the reason why a need is not met; nullopt if it is met.
  std::optional<texts::UserMessage> Unmet(Need need) const;

  /// Advances by 1/60 s.
  /// @returns false if the world waits because a brain starts or thinks.
  bool Tick();
  /// Returns the number of calls of Tick().
  std::uint64_t num_ticks() const { return num_ticks_; }

  /// Replaces the live world. The brain and playback end.
  void Enter(std::unique_ptr<LiveWorld> world);
  /// Applies a command to the live world. A load, and the undo of one, count as another world.
  /// @returns the reason of a refusal.
  std::optional<sim::Refusal> Apply(const sim::Command& command);
  /// Starts the imitation state; requires a running program and a recording in progress.
  void Imitate(task::ImitationTask imitation_task);
  /// Starts the clear-table animation, which must be possible.
  void AnimateClearTable();
  /// Returns to the live state if the present state of the world is over.
  void EndIfOver();
  void Show(std::unique_ptr<PlaybackState> playback);
  void GoLive();
  /// Starts restoring, until TakeRestored(). The object is shared with the thread that makes the
  /// world.
  void Restore(std::shared_ptr<Restoring> restoring) { restoring_ = std::move(restoring); }
  /// Ends restoring. Returns the world that was made; nullptr if that failed.
  std::unique_ptr<LiveWorld> TakeRestored();

 private:
  /// Ends everything that belongs to the live world.
  void LeaveWorld();
  /// Starts the live state in a new world or scene.
  void BeginWorld();

  const bool has_robot_;
  Listener* listener_;
  Pace pace_;
  std::uint64_t num_ticks_ = 0;
  std::unique_ptr<LiveWorld> world_;
  LiveBrain brain_;
  std::unique_ptr<SessionState> world_state_;  ///< never playback
  std::unique_ptr<PlaybackState> playback_;
  std::shared_ptr<Restoring> restoring_;
};

}  // namespace smile::studio
