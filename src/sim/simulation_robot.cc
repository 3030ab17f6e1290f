// How a simulation's robot is commanded.

#include <array>
#include <string_view>

#include "base/wording.h"
#include "sim/simulation.h"

namespace smile::sim {
namespace {

constexpr const char* kNoRobot = "there is no robot in this simulation";

}  // namespace

std::optional<Refusal> Simulation::RefuseArm(const std::optional<std::vector<double>>& values,
                                             int arm) const {
  if (!robot_) return kNoRobot;
  if (!values) return std::nullopt;
  if (arm >= robot_->num_arms()) return "the robot has no such arm";
  const robot::Arm& which = robot_->model().arms[arm];
  if (values->size() == which.joints.size()) return std::nullopt;
  return "the " + which.name + " arm has " + std::to_string(which.joints.size()) +
         " joints, found " + std::to_string(values->size()) + " numbers";
}

void Simulation::LeaveArm(int arm) {
  for (const int joint : robot_->model().arms[arm].joints) follower_->Leave(joint);
}

void Simulation::LeaveGripper(int arm) {
  const auto& gripper = robot_->model().arms[arm].gripper;
  if (gripper) follower_->Leave(gripper->left_finger);
}

void Simulation::LeaveHead() {
  if (robot_->model().head) follower_->Leave(robot_->model().head->joint);
}

std::optional<Refusal> Simulation::Carry(const JointVelocities& velocities) {
  if (auto refusal = RefuseArm(velocities.left, 0)) return refusal;
  if (auto refusal = RefuseArm(velocities.right, 1)) return refusal;
  const std::array arms{&velocities.left, &velocities.right};
  for (int arm = 0; arm < 2; ++arm) {
    if (!*arms[arm]) continue;
    LeaveArm(arm);
    robot_->SetArmVelocities(arm, **arms[arm]);
  }
  for (int arm = 0; velocities.grippers && arm < robot_->num_arms() && arm < 2; ++arm) {
    LeaveGripper(arm);
    robot_->SetGripperVelocity(arm, (*velocities.grippers)[arm]);
  }
  if (velocities.head) {
    LeaveHead();
    robot_->SetHeadVelocity(*velocities.head);
  }
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const JointAngles& angles) {
  if (auto refusal = RefuseArm(angles.left, 0)) return refusal;
  if (auto refusal = RefuseArm(angles.right, 1)) return refusal;
  const std::array arms{&angles.left, &angles.right};
  for (int arm = 0; arm < 2; ++arm) {
    if (!*arms[arm]) continue;
    LeaveArm(arm);
    robot_->SetArmAngles(arm, **arms[arm]);
  }
  if (angles.head) {
    LeaveHead();
    robot_->SetHeadAngle(*angles.head);
  }
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const TurnJoint& turn) {
  if (!robot_) return kNoRobot;
  const motion::Channel* channel = FindChannel(follower_->channels(), turn.joint);
  if (channel == nullptr || channel->is_gripper()) {
    std::vector<std::string_view> names;
    for (const motion::Channel& known : follower_->channels()) {
      if (!known.is_gripper()) names.push_back(known.name);
    }
    return "the robot has no joint " + Quoted(turn.joint) + " to turn" +
           DidYouMean(turn.joint, names);
  }
  follower_->Leave(channel->joint);
  robot_->SetJointVelocity(channel->joint, turn.velocity);
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const MoveGripper& move) {
  using enum MoveGripper::Which;
  if (!robot_) return kNoRobot;
  for (int arm = 0; arm < 2; ++arm) {
    if (move.which == (arm == 0 ? kRight : kLeft)) continue;
    if (arm >= robot_->num_arms() || !robot_->model().arms[arm].gripper) {
      return "the robot has no gripper there";
    }
  }
  for (int arm = 0; arm < 2; ++arm) {
    if (move.which == (arm == 0 ? kRight : kLeft)) continue;
    LeaveGripper(arm);
    robot_->SetGripperVelocity(arm, move.velocity);
  }
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const TakePose& pose) {
  if (!robot_) return kNoRobot;
  return follower_->MoveTo(pose.name, pose.speed, tick_);
}

std::optional<Refusal> Simulation::Carry(const FollowTrajectory& follow) {
  if (!robot_) return kNoRobot;
  return follower_->Follow(follow.trajectory, tick_);
}

std::optional<Refusal> Simulation::Carry(const ShowRobot& show) {
  if (!robot_) return kNoRobot;
  is_robot_shown_ = show.is_shown;
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const Face& face) {
  if (!robot_) return kNoRobot;
  mood_ = face.mood;
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const Markers& markers) {
  if (markers.points_in_world.size() <= kMaxMarkers) return std::nullopt;
  return "there are more than " + std::to_string(kMaxMarkers) + " markers";
}

}  // namespace smile::sim
