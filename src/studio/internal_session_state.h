#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/json.h"
#include "library/playback.h"
#include "library/view.h"
#include "model/eye.h"
#include "model/model.h"
#include "studio/clear_table_animation.h"
#include "studio/live_brain.h"
#include "studio/live_world.h"
#include "task/imitation_result.h"

// The states of a session: each shows something, lets something go on while time goes by, and
// decides which needs of requests are met.

namespace smile::studio {

/// A condition of a request.
enum class Need {
  kCommands,      ///< the live world takes commands
  kTime,          ///< its time may be stopped
  kOtherWorld,    ///< another world may take its place
  kNewRecording,  ///< a recording of it may begin
  kShow,          ///< a recording may be shown
  kPlayback,      ///< one is shown
  kRobot,
  kProgram,
  kNoProgram,
};

/// An activity of a session: while it lasts, some needs are not met.
class Activity {
 public:
  virtual ~Activity() = default;

  /// The reason why a need is not met; nullopt unless this activity stands against it.
  virtual std::optional<std::string> Unmet(Need need) const = 0;
};

class SessionState : public Activity {
 public:
  /// `mode` of a state message.
  virtual const char* mode() const = 0;

  /// Of what is shown.
  virtual const model::Model& model() const = 0;
  /// `scene` is the caller's to fill in.
  virtual library::View view() const = 0;
  virtual model::ViewSample ViewSampleThrough(model::EyeSpec eye) const = 0;
  /// What a state message says of it: tick, hands, controls, the robot.
  virtual Json Describe() const = 0;

  /// 1/60 s goes by.
  /// @returns false if the world stood still because a robot program starts or thinks.
  virtual bool Tick(bool is_paused) = 0;
  /// The live world follows.
  virtual bool is_over() const { return false; }
  /// Ends it when it is over, or stopped.
  /// @returns a message for all; nullopt without one.
  virtual std::optional<Json> End(double /*measured_speed*/) { return std::nullopt; }
};

/// A state of the live world.
class WorldState : public SessionState {
 public:
  /// `world` must outlive this.
  explicit WorldState(LiveWorld* world) : world_(world) {}

  /// While it is recorded, the world stays, and is shown.
  std::optional<std::string> Unmet(Need need) const override;

 protected:
  LiveWorld& world() { return *world_; }
  const LiveWorld& world() const { return *world_; }

 private:
  LiveWorld* world_;
};

/// People and a robot program act in the world.
class LiveState : public WorldState {
 public:
  /// Both must outlive this.
  LiveState(LiveWorld* world, LiveBrain* brain) : WorldState(world), brain_(brain) {}

  const char* mode() const override { return "live"; }
  const model::Model& model() const override { return world().simulation().model(); }
  library::View view() const override;
  model::ViewSample ViewSampleThrough(model::EyeSpec eye) const override;
  Json Describe() const override;
  bool Tick(bool is_paused) override;

 protected:
  LiveBrain& brain() { return *brain_; }
  const LiveBrain& brain() const { return *brain_; }

 private:
  LiveBrain* brain_;
};

/// A robot program imitates a demonstration, recorded, until it ends or its time is over.
class ImitatingState : public LiveState {
 public:
  /// The program runs and the recording has begun.
  ImitatingState(task::ImitationTask imitation_task, LiveWorld* world, LiveBrain* brain);

  bool Tick(bool is_paused) override;
  bool is_over() const override { return !brain().is_running(); }
  /// Finishes the recording, if it still goes on; returns the score.
  std::optional<Json> End(double measured_speed) override;

 private:
  task::ImitationTask task_;
  task::EpisodeObserver observer_;
  std::filesystem::path recording_;  ///< its directory
  std::uint64_t start_tick_ = 0;
};

/// The robot clears the table, in a copy of the world.
class ClearTableState : public WorldState {
 public:
  /// Requires ClearTableAnimation::IsPossible(). `world` must outlive this.
  explicit ClearTableState(LiveWorld* world) : WorldState(world), animation_(world->simulation()) {}

  const char* mode() const override { return "rage"; }
  std::optional<std::string> Unmet(Need need) const override;
  const model::Model& model() const override { return animation_.simulation().model(); }
  library::View view() const override;
  model::ViewSample ViewSampleThrough(model::EyeSpec eye) const override;
  Json Describe() const override;
  bool Tick(bool is_paused) override;
  bool is_over() const override { return animation_.is_over(); }

 private:
  ClearTableAnimation animation_;
};

/// A recording is shown; the world waits.
class PlaybackState : public SessionState {
 public:
  /// @throws InputError if the recording cannot be read.
  PlaybackState(std::string id, const std::filesystem::path& directory)
      : playback_(std::move(id), directory) {}

  library::Playback& playback() { return playback_; }
  const library::Playback& playback() const { return playback_; }
  /// `playback` of a state message.
  Json DescribePlayback() const;

  const char* mode() const override { return "playback"; }
  std::optional<std::string> Unmet(Need need) const override;
  const model::Model& model() const override { return playback_.model(); }
  library::View view() const override;
  /// With the camera that the recording was made with.
  model::ViewSample ViewSampleThrough(model::EyeSpec eye) const override;
  Json Describe() const override;
  /// A pause is the world's alone.
  bool Tick(bool is_paused) override;

 private:
  library::Playback playback_;
};

}  // namespace smile::studio
