#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// Column of a trajectory: a joint of a robot, or the opening of a gripper (the free width between
/// its two sides, which move as one).
struct TrajectoryChannel {
  std::string name;     ///< name of the joint; `left_gripper`, `right_gripper`
  int joint = -1;       ///< index into RobotModel::links; of a gripper, robot::LeadingJointOf()
  int gripper_of = -1;  ///< index of the gripper's arm; -1 for a joint
  JointLimits limits;   ///< [rad or m]

  bool is_gripper() const { return gripper_of >= 0; }
};

/// Returns the joints and gripper of each arm, left first, then the head, then all other joints but
/// those that mimic one. A suction cup has no channel.
std::vector<TrajectoryChannel> ChannelsOf(const robot::RobotModel& model);

/// Returns the channel of that name, or nullptr.
[[nodiscard]] const TrajectoryChannel* FindChannel(std::span<const TrajectoryChannel> channels,
                                                   std::string_view name);

/// Returns its position at a configuration `q` of its robot [rad or m].
double PositionOf(const TrajectoryChannel& channel, const robot::RobotModel& model,
                  std::span<const double> q);

}  // namespace smile::motion
