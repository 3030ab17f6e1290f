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

/// How time goes by in a session.
struct Pace {
  bool is_paused = false;
  double speed_factor = 1;    ///< wanted, of simulated to real time
  double measured_speed = 1;  ///< over the last second
};

/// The states of a session and the transitions between them, with the world and the robot program
/// that they are about.
///
/// The live world is always in one state: live, imitating or clearing the table (rage). Playback
/// may lie over it, and is shown instead. Restoring goes on beneath both, in another thread.
class StateMachine {
 public:
  class Listener {
   public:
    virtual ~Listener() = default;
    /// Another world is live, or the world is in another scene.
    virtual void OnOtherWorld() = 0;
    /// Another scene is shown, maybe that of another world.
    virtual void OnOtherScene() = 0;
    /// An imitation is over: its score, as a message for all.
    virtual void OnScore(Json score) = 0;
  };

  /// To be used after the first Enter(). `listener` must outlive this.
  /// @param has_robot  worlds have a robot.
  StateMachine(bool has_robot, Listener* listener) : has_robot_(has_robot), listener_(listener) {}
  StateMachine(const StateMachine&) = delete;
  StateMachine& operator=(const StateMachine&) = delete;

  LiveWorld& world() { return *world_; }
  const LiveWorld& world() const { return *world_; }
  LiveBrain& brain() { return brain_; }
  const LiveBrain& brain() const { return brain_; }
  Pace& pace() { return pace_; }
  const Pace& pace() const { return pace_; }

  /// The state whose scene is shown.
  const SessionState& shown() const { return playback_ ? *playback_ : *world_state_; }
  /// nullptr unless a recording is shown.
  PlaybackState* playback() { return playback_.get(); }
  const PlaybackState* playback() const { return playback_.get(); }
  /// Returns nullptr unless a recording is being continued from a point of its history.
  const Restoring* restoring() const { return restoring_.get(); }
  /// The reason why a need is not met; nullopt if it is.
  std::optional<std::string> Unmet(Need need) const;

  /// 1/60 s goes by.
  /// @returns false if the world stood still because a robot program starts or thinks.
  bool Tick();
  /// Counts the calls of Tick().
  std::uint64_t num_ticks() const { return num_ticks_; }

  /// Another world is live. The robot program ends with the world it was in, and so does playback.
  void Enter(std::unique_ptr<LiveWorld> world);
  /// Applies a command to the live world. A load, and the undo of one, is like another world.
  /// @returns why it was refused.
  std::optional<sim::Refusal> Apply(const sim::Command& command);
  /// The program runs and the recording has begun.
  void Imitate(task::ImitationTask imitation_task);
  /// Starts the clear-table animation, which must be possible.
  void AnimateClearTable();
  /// The world's state is live if what went on in it is over.
  void EndIfOver();
  void Show(std::unique_ptr<PlaybackState> playback);
  void GoLive();
  /// Lasts until TakeRestored(). The object belongs also to the thread that makes the world.
  void Restore(std::shared_ptr<Restoring> restoring) { restoring_ = std::move(restoring); }
  /// Restoring is over. Returns the world that was made; nullptr if that failed.
  std::unique_ptr<LiveWorld> TakeRestored();

 private:
  /// What belongs to the live world ends.
  void LeaveWorld();
  /// The live world is another one, or in another scene.
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
