#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/state_hash.h"
#include "motion/channels.h"
#include "motion/joint_trajectory.h"
#include "world/refusal.h"
#include "world/robot_body.h"

namespace smile::sim {

using world::Refusal;

/// A trajectory on its way.
struct Following {
  /// What of the robot follows which column, as long as nobody else commands it.
  struct Column {
    std::size_t column = 0;   ///< of the trajectory
    std::size_t channel = 0;  ///< of the robot, see motion::ChannelsOf()

    bool operator==(const Column&) const = default;
  };

  /// Never changes, may be long, and every saved state on its way has it: these share it.
  std::shared_ptr<const motion::JointTrajectory> trajectory;
  std::uint64_t hash = 0;  ///< of it
  std::uint64_t start_tick = 0;
  std::vector<Column> columns;
};

/// What a TrajectoryFollower remembers; part of every saved state.
struct FollowerState {
  std::vector<Following> followings;  ///< in the order of their starts
};

/// Makes joints of a robot follow trajectories, by their velocities.
///
/// Each tick a joint gets the velocity that the trajectory has for it, and a share of what it is
/// off. A joint that is blocked falls behind, and catches up as fast as its limit allows; when the
/// time is up, it stops, wherever it is. A joint follows one trajectory at a time.
class TrajectoryFollower {
 public:
  /// @param robot  outlives this.
  explicit TrajectoryFollower(world::RobotBody* robot);

  /// Begins to follow. Joints that are elsewhere first go straight to where it begins.
  /// @returns why not: an unknown joint, a limit of position or velocity that it breaks.
  std::optional<Refusal> Follow(const motion::JointTrajectory& trajectory, std::uint64_t tick);
  /// Begins to move straight to a named pose, grippers excepted.
  std::optional<Refusal> MoveTo(const std::string& pose, double speed, std::uint64_t tick);
  /// Somebody else commands this joint from now on; a left finger stands for its gripper.
  void Leave(int joint);

  /// Commands the joints for the tick that begins.
  void BeforeTick(std::uint64_t tick);

  bool is_following() const { return !state_.followings.empty(); }
  std::span<const motion::Channel> channels() const { return channels_; }

  const FollowerState& state() const { return state_; }
  void Restore(const FollowerState& state) { state_ = state; }
  void AddToHash(StateHash* hash) const;

 private:
  std::optional<Refusal> FindColumns(const motion::JointTrajectory& trajectory,
                                     std::vector<Following::Column>* columns) const;
  std::optional<Refusal> RefuseBeyondLimits(const motion::JointTrajectory& trajectory,
                                            std::span<const Following::Column> columns) const;
  /// The trajectory, with the way to where it begins before it.
  motion::JointTrajectory WithWayToStart(motion::JointTrajectory trajectory,
                                         std::span<const Following::Column> columns) const;
  void Start(motion::JointTrajectory trajectory, std::vector<Following::Column> columns,
             std::uint64_t tick);
  void Drive(const Following& following, std::uint64_t tick);
  void DriveGripper(int arm, double rate, double error);
  void Stop(const Following& following);

  world::RobotBody& robot_;
  std::vector<motion::Channel> channels_;
  FollowerState state_;
};

}  // namespace smile::sim
