#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/json.h"
#include "library/displayed_state.h"
#include "library/playback.h"
#include "model/eye.h"
#include "model/model.h"
#include "studio/clear_table_animation.h"
#include "studio/live_brain.h"
#include "studio/live_world.h"
#include "task/imitation_result.h"

// States of a session: each has a view, advances with time, and decides which needs of requests are
// met.

namespace smile::studio {

/// Condition of a request.
enum class Need {
  kCommands,      ///< the live world accepts commands
  kTime,          ///< its time may be paused
  kOtherWorld,    ///< it may be replaced by another world
  kNewRecording,  ///< a recording of it may start
  kShow,          ///< a recording may be shown
  kPlayback,      ///< a recording is shown
  kRobot,
  kProgram,
  kNoProgram,
};

/// Activity of a session: while it lasts, some needs are not met.
class Activity {
 public:
  virtual ~Activity() = default;

  /// Returns the reason why a need is not met; nullopt unless this activity prevents it.
  virtual std::optional<texts::UserMessage> Unmet(Need need) const = 0;
};

class SessionState : public Activity {
 public:
  /// Returns `mode` of a state message.
  virtual const char* mode() const = 0;

  /// Returns the model that is shown.
  virtual const model::Model& model() const = 0;
  /// Returns the view; the caller sets its member `scene`.
  virtual library::DisplayedState view() const = 0;
  virtual model::ViewSample ViewSampleThrough(model::EyeSpec eye) const = 0;
  /// Returns the part of a state message that depends on this state: tick, hands, controls, the
  /// robot.
  virtual Json Describe() const = 0;

  /// Advances by 1/60 s.
  /// @returns false if the world waits because a brain starts or thinks.
  virtual bool Tick(bool is_paused) = 0;
  /// True if the state ends; the live state follows.
  virtual bool is_over() const { return false; }
  /// Ends the state when it is over or stopped.
  /// @returns a message for all clients; nullopt without one.
  virtual std::optional<Json> End(double /*measured_speed*/) { return std::nullopt; }
};

/// State of the live world.
class WorldState : public SessionState {
 public:
  /// `world` must outlive this.
  explicit WorldState(LiveWorld* world) : world_(world) {}

  /// While it is recorded, the world can neither be replaced nor hidden by playback.
  std::optional<texts::UserMessage> Unmet(Need need) const override;

 protected:
  LiveWorld& world() { return *world_; }
  const LiveWorld& world() const { return *world_; }

 private:
  LiveWorld* world_;
};

/// Live state: people and a brain act in the world.
class LiveState : public WorldState {
 public:
  /// Both must outlive this.
  LiveState(LiveWorld* world, LiveBrain* brain) : WorldState(world), brain_(brain) {}

  const char* mode() const override { return "live"; }
  const model::Model& model() const override { return world().simulation().model(); }
  library::DisplayedState view() const override;
  model::ViewSample ViewSampleThrough(model::EyeSpec eye) const override;
  Json Describe() const override;
  bool Tick(bool is_paused) override;

 protected:
  LiveBrain& brain() { return *brain_; }
  const LiveBrain& brain() const { return *brain_; }

 private:
  LiveBrain* brain_;
};

/// Imitation: a brain imitates a demonstration, recorded, until it ends or exceeds its
/// time.
class ImitatingState : public LiveState {
 public:
  /// Requires a running program and a recording in progress.
  ImitatingState(task::ImitationTask imitation_task, LiveWorld* world, LiveBrain* brain);

  bool Tick(bool is_paused) override;
  /// True once what the brain built has stood for task::kRestSeconds, or at once if it did not end
  /// by itself.
  bool is_over() const override;
  /// Finishes the recording, if it is still in progress; returns the score.
  std::optional<Json> End(double measured_speed) override;

 private:
  task::ImitationTask task_;
  task::EpisodeObserver observer_;
  std::filesystem::path recording_;  ///< its directory
  std::uint64_t start_tick_ = 0;
  /// End of the brain. Another one may be started while what it built rests.
  struct BrainEnd {
    std::uint64_t tick = 0;
    Json brain;
  };
  std::optional<BrainEnd> end_;
};

/// Clear-table animation, in a copy of the world.
class ClearTableState : public WorldState {
 public:
  /// Requires ClearTableAnimation::IsPossible(). `world` must outlive this.
  explicit ClearTableState(LiveWorld* world) : WorldState(world), animation_(world->simulation()) {}

  const char* mode() const override { return "rage"; }
  std::optional<texts::UserMessage> Unmet(Need need) const override;
  const model::Model& model() const override { return animation_.simulation().model(); }
  library::DisplayedState view() const override;
  model::ViewSample ViewSampleThrough(model::EyeSpec eye) const override;
  Json Describe() const override;
  bool Tick(bool is_paused) override;
  bool is_over() const override { return animation_.is_over(); }

 private:
  ClearTableAnimation animation_;
};

/// Playback: a recording is shown; the world waits.
class PlaybackState : public SessionState {
 public:
  /// @throws InputError if the recording cannot be read.
  PlaybackState(std::string id, const std::filesystem::path& directory)
      : playback_(std::move(id), directory) {}

  library::Playback& playback() { return playback_; }
  const library::Playback& playback() const { return playback_; }
  /// Returns `playback` of a state message.
  Json DescribePlayback() const;

  const char* mode() const override { return "playback"; }
  std::optional<texts::UserMessage> Unmet(Need need) const override;
  const model::Model& model() const override { return playback_.model(); }
  library::DisplayedState view() const override;
  /// Returns the sample through the camera of the recording.
  model::ViewSample ViewSampleThrough(model::EyeSpec eye) const override;
  Json Describe() const override;
  /// Advances the playback; pausing the world does not affect it.
  bool Tick(bool is_paused) override;

 private:
  library::Playback playback_;
};

}  // namespace smile::studio
