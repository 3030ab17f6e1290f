#include "motion/channels.h"

#include <algorithm>

namespace smile::motion {
namespace {

JointLimits LimitsOfJoint(const robot::RobotModel& model, int joint) {
  return LimitsOf(model, std::span(&joint, 1)).front();
}

TrajectoryChannel JointChannel(const robot::RobotModel& model, int joint) {
  return {
      .name = model.links[joint].joint_name, .joint = joint, .limits = LimitsOfJoint(model, joint)};
}

/// Returns the channel of a gripper. Its opening is the sum of both fingers' positions and of the
/// gap that remains when both are at 0; both fingers move at the speed of the slower one.
TrajectoryChannel GripperChannel(const robot::RobotModel& model, int arm) {
  const robot::Gripper& gripper = *model.arms[arm].gripper;
  const JointLimits left = LimitsOfJoint(model, gripper.left_finger);
  const JointLimits right = LimitsOfJoint(model, gripper.right_finger);
  return {
      .name = model.arms[arm].name + "_gripper",
      .joint = gripper.left_finger,
      .gripper_of = arm,
      .limits = {.lower = left.lower + right.lower + gripper.closed_opening,
                 .upper = left.upper + right.upper + gripper.closed_opening,
                 .max_velocity = 2 * std::min(left.max_velocity, right.max_velocity),
                 .max_acceleration = 2 * std::min(left.max_acceleration, right.max_acceleration),
                 .slides = true}};
}

}  // namespace

std::vector<TrajectoryChannel> ChannelsOf(const robot::RobotModel& model) {
  std::vector<TrajectoryChannel> channels;
  std::vector<bool> has_channel(model.links.size());
  // The order is that of the columns in exported files. A joint that two lists name, for example a
  // head that is also a joint of the model, gets one column.
  const auto add_joint = [&](int joint) {
    if (has_channel[joint]) return;
    channels.push_back(JointChannel(model, joint));
    has_channel[joint] = true;
  };
  for (int arm = 0; arm < static_cast<int>(model.arms.size()); ++arm) {
    for (const int joint : model.arms[arm].joints) add_joint(joint);
    const auto& gripper = model.arms[arm].gripper;
    if (!gripper) continue;
    channels.push_back(GripperChannel(model, arm));
    // Fingers have no channels of their own: the opening moves both.
    has_channel[gripper->left_finger] = has_channel[gripper->right_finger] = true;
  }
  if (model.head) add_joint(model.head->joint);
  for (int joint = 0; joint < model.num_joints(); ++joint) add_joint(joint);
  return channels;
}

const TrajectoryChannel* FindChannel(std::span<const TrajectoryChannel> channels,
                                     std::string_view name) {
  const auto found = std::ranges::find(channels, name, &TrajectoryChannel::name);
  return found == channels.end() ? nullptr : &*found;
}

double PositionOf(const TrajectoryChannel& channel, const robot::RobotModel& model,
                  std::span<const double> q) {
  if (!channel.is_gripper()) return q[channel.joint];
  const robot::Gripper& gripper = *model.arms[channel.gripper_of].gripper;
  // Positions of fingers are distances from closed, so their sum is what opened.
  return q[gripper.left_finger] + q[gripper.right_finger] + gripper.closed_opening;
}

}  // namespace smile::motion
