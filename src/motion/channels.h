#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// What of a robot has a column in a trajectory: a joint, or the opening of a gripper, the free
/// width between its two fingers, which move as one.
struct Channel {
  std::string name;     ///< of the joint; `left_gripper`, `right_gripper`
  int joint = -1;       ///< index into RobotModel::links; of a gripper its left finger
  int gripper_of = -1;  ///< index of the arm whose gripper it is; -1 of a joint
  JointLimits limits;   ///< [rad or m]

  bool is_gripper() const { return gripper_of >= 0; }
};

/// Every arm's joints and its gripper, left first, then the head, then what else turns or slides.
std::vector<Channel> ChannelsOf(const robot::RobotModel& model);

/// nullptr when there is none of that name.
[[nodiscard]] const Channel* FindChannel(std::span<const Channel> channels, std::string_view name);

/// Where it is at a configuration `q` of its robot [rad or m].
double PositionOf(const Channel& channel, const robot::RobotModel& model,
                  std::span<const double> q);

}  // namespace smile::motion
