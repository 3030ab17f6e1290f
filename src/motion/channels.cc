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

/// Returns the channel of a gripper, whose position is its opening.
TrajectoryChannel GripperChannel(const robot::RobotModel& model, int arm) {
  const robot::Gripper& gripper = *model.arms[arm].gripper;
  const robot::OpeningRange range = OpeningRangeOf(model, gripper);
  return {.name = model.arms[arm].name + "_gripper",
          .joint = LeadingJointOf(gripper),
          .gripper_of = arm,
          .limits = {.lower = range.closed,
                     .upper = range.open,
                     .max_velocity = range.max_speed,
                     .max_acceleration = range.max_speed / kSecondsToFullSpeed,
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
    // A suction cup has nothing that moves.
    if (!gripper || LeadingJointOf(*gripper) < 0) continue;
    channels.push_back(GripperChannel(model, arm));
    // The joints of a gripper have no channels of their own: the opening moves them.
    for (const int joint : JointsOf(model, *gripper)) has_channel[joint] = true;
  }
  for (const int joint : model.head ? model.head->joints : std::vector<int>()) add_joint(joint);
  for (int joint = 0; joint < model.num_joints(); ++joint) {
    if (!model.links[joint].mimic) add_joint(joint);
  }
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
  return OpeningOf(model, *model.arms[channel.gripper_of].gripper, q);
}

}  // namespace smile::motion
