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

/// A trajectory that is being followed.
struct Following {
  /// A channel of the robot and the column it follows, until it gets another command.
  struct Column {
    std::size_t column = 0;   ///< of the trajectory
    std::size_t channel = 0;  ///< of the robot, see motion::ChannelsOf()

    bool operator==(const Column&) const = default;
  };

  /// Shared, since it never changes, may be long, and is part of each saved state.
  std::shared_ptr<const motion::JointTrajectory> trajectory;
  std::uint64_t hash = 0;  ///< of the trajectory
  std::uint64_t start_tick = 0;
  std::vector<Column> columns;
};

/// State of a TrajectoryFollower; part of each saved state.
struct FollowerState {
  std::vector<Following> followings;  ///< in the order of their starts
};

/// Makes joints of a robot follow trajectories by commanding velocities.
///
/// Each tick a joint gets the velocity of the trajectory plus a correction proportional to its
/// error. A blocked joint falls behind and catches up as fast as its limit allows; when the time is
/// up, it stops wherever it is. A joint follows one trajectory at a time.
class TrajectoryFollower {
 public:
  /// Makes a follower.
  /// @param robot  must outlive this.
  explicit TrajectoryFollower(world::RobotBody* robot);

  /// Starts to follow. Joints that are elsewhere first move straight to the trajectory's start.
  /// @returns the reason if refused: an unknown joint, or a violated limit of position or velocity.
  std::optional<Refusal> Follow(const motion::JointTrajectory& trajectory, std::uint64_t tick);
  /// Starts to move straight to a named pose, except grippers.
  std::optional<Refusal> MoveTo(const std::string& pose, double speed, std::uint64_t tick);
  /// Ends following by a joint that gets another command; robot::LeadingJointOf() stands for a
  /// gripper.
  void Leave(int joint);

  /// Commands the joints for the tick that begins.
  void BeforeTick(std::uint64_t tick);

  bool is_following() const { return !state_.followings.empty(); }
  std::span<const motion::TrajectoryChannel> channels() const { return channels_; }

  const FollowerState& state() const { return state_; }
  void Restore(const FollowerState& state) { state_ = state; }
  void AddToHash(StateHash* hash) const;

 private:
  std::optional<Refusal> FindColumns(const motion::JointTrajectory& trajectory,
                                     std::vector<Following::Column>* columns) const;
  std::optional<Refusal> RefuseBeyondLimits(const motion::JointTrajectory& trajectory,
                                            std::span<const Following::Column> columns) const;
  /// Returns the trajectory preceded by the motion to its start.
  motion::JointTrajectory WithApproachToStart(motion::JointTrajectory trajectory,
                                              std::span<const Following::Column> columns) const;
  void Start(motion::JointTrajectory trajectory, std::vector<Following::Column> columns,
             std::uint64_t tick);
  void Drive(const Following& following, std::uint64_t tick);
  void DriveGripper(int arm, double rate, double error);
  void Stop(const Following& following);

  world::RobotBody& robot_;
  std::vector<motion::TrajectoryChannel> channels_;
  FollowerState state_;
};

}  // namespace smile::sim
