// Commands of the robot. Each is checked completely before it changes anything; commands of joints
// end the trajectories that these follow.

#include "sim/simulated_robot.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "base/wording.h"

namespace smile::sim {

using texts::Say;

JointVelocities StillVelocities(const robot::RobotModel& model) {
  JointVelocities still;
  for (const robot::Arm& arm : model.arms) {
    still.arms[arm.name] = std::vector<double>(arm.joints.size(), 0.0);
    if (arm.gripper) still.grippers[arm.name] = 0;
  }
  if (model.head) still.head = 0;
  return still;
}

SimulatedRobot::SimulatedRobot(physics::World* world, std::shared_ptr<const model::Model> model)
    : body_(world, std::move(model)), follower_(&body_) {}

std::optional<int> SimulatedRobot::FindArm(std::string_view name) const {
  const std::vector<robot::Arm>& arms = body_.model().arms;
  const auto found = std::ranges::find(arms, name, &robot::Arm::name);
  if (found != arms.end()) return static_cast<int>(found - arms.begin());
  // The first and the second arm of any robot.
  const int side = name == "left" ? 0 : name == "right" ? 1 : body_.num_arms();
  return side < body_.num_arms() ? std::optional(side) : std::nullopt;
}

std::optional<int> SimulatedRobot::FindGripper(std::string_view name) const {
  const std::optional<int> arm = FindArm(name);
  return arm && body_.model().arms[*arm].gripper ? arm : std::nullopt;
}

Refusal SimulatedRobot::NoSuchArm(std::string_view name) const {
  std::vector<std::string_view> names;
  for (const robot::Arm& arm : body_.model().arms) names.push_back(arm.name);
  return "the robot has no arm " + Quoted(name) +
         (names.empty() ? std::string() : ", expected " + OneOf(names));
}

std::optional<Refusal> SimulatedRobot::RefuseValues(
    const ByArm<std::vector<double>>& values) const {
  std::set<int> arms;
  for (const auto& [name, numbers] : values) {
    const std::optional<int> arm = FindArm(name);
    if (!arm) return NoSuchArm(name);
    const robot::Arm& which = body_.model().arms[*arm];
    if (!arms.insert(*arm).second) return "the arm " + Quoted(which.name) + " is named twice";
    if (numbers.size() == which.joints.size()) continue;
    return "the " + which.name + " arm has " + std::to_string(which.joints.size()) +
           " joints, found " + std::to_string(numbers.size()) + " numbers";
  }
  return std::nullopt;
}

std::optional<Refusal> SimulatedRobot::RefuseRates(const ByArm<double>& rates) const {
  if (IsPair(rates)) return std::nullopt;
  std::set<int> arms;
  for (const auto& [name, rate] : rates) {
    if (!FindArm(name)) return NoSuchArm(name);
    if (!FindGripper(name)) return Say("robot.armHasNoGripper", {{"arm", Quoted(name)}});
    if (!arms.insert(*FindArm(name)).second) return "the arm " + Quoted(name) + " is named twice";
  }
  return std::nullopt;
}

void SimulatedRobot::StopFollowingWithArm(int arm) {
  for (const int joint : body_.model().arms[arm].joints) follower_.Leave(joint);
}

void SimulatedRobot::StopFollowingWithGripper(int arm) {
  const auto& gripper = body_.model().arms[arm].gripper;
  if (gripper) follower_.Leave(LeadingJointOf(*gripper));
}

void SimulatedRobot::StopFollowingWithHead() {
  const auto& head = body_.model().head;
  if (head && !head->joints.empty()) follower_.Leave(head->joints.front());
}

void SimulatedRobot::SetGripper(int arm, double velocity) {
  StopFollowingWithGripper(arm);
  body_.SetGripperVelocity(arm, velocity);
}

std::optional<Refusal> SimulatedRobot::Execute(const JointVelocities& velocities) {
  if (auto refusal = RefuseValues(velocities.arms)) return refusal;
  if (auto refusal = RefuseRates(velocities.grippers)) return refusal;
  // Everything is checked; from here on nothing can be refused.
  for (const auto& [name, numbers] : velocities.arms) {
    const int arm = *FindArm(name);
    StopFollowingWithArm(arm);
    body_.SetArmVelocities(arm, numbers);
  }
  for (const auto& [name, rate] : velocities.grippers) {
    if (const auto arm = FindGripper(name)) SetGripper(*arm, rate);
  }
  if (velocities.head) {
    StopFollowingWithHead();
    body_.SetHeadVelocity(*velocities.head);
  }
  return std::nullopt;
}

std::optional<Refusal> SimulatedRobot::Execute(const JointAngles& angles) {
  if (auto refusal = RefuseValues(angles.arms)) return refusal;
  // Sets the angles at once, without motion; held objects move along.
  for (const auto& [name, numbers] : angles.arms) {
    const int arm = *FindArm(name);
    StopFollowingWithArm(arm);
    body_.SetArmAngles(arm, numbers);
  }
  if (angles.head) {
    StopFollowingWithHead();
    body_.SetHeadAngle(*angles.head);
  }
  return std::nullopt;
}

std::optional<Refusal> SimulatedRobot::Execute(const TurnJoint& turn) {
  const motion::TrajectoryChannel* channel = FindChannel(follower_.channels(), turn.joint);
  // Fingers move only as a pair, by the gripper command.
  if (channel == nullptr || channel->is_gripper()) {
    std::vector<std::string_view> names;
    for (const motion::TrajectoryChannel& known : follower_.channels()) {
      if (!known.is_gripper()) names.push_back(known.name);
    }
    return "the robot has no joint " + Quoted(turn.joint) + " to turn" +
           DidYouMean(turn.joint, names);
  }
  // The last command for a joint wins.
  follower_.Leave(channel->joint);
  body_.SetJointVelocity(channel->joint, turn.velocity);
  return std::nullopt;
}

std::optional<Refusal> SimulatedRobot::Execute(const MoveGripper& move) {
  std::vector<int> arms;
  if (move.arm == "all") {
    for (int arm = 0; arm < body_.num_arms(); ++arm) {
      if (body_.model().arms[arm].gripper) arms.push_back(arm);
    }
    if (arms.empty()) return Say("robot.noGripper");
  } else {
    const std::vector<std::string_view> names = move.arm == "both"
                                                    ? std::vector<std::string_view>{"left", "right"}
                                                    : std::vector<std::string_view>{move.arm};
    // All are checked before one of them moves.
    for (const std::string_view name : names) {
      if (!FindArm(name)) return NoSuchArm(name);
      if (!FindGripper(name)) return Say("robot.armHasNoGripper", {{"arm", Quoted(name)}});
      arms.push_back(*FindArm(name));
    }
  }
  for (const int arm : arms) SetGripper(arm, move.velocity);
  return std::nullopt;
}

std::optional<Refusal> SimulatedRobot::Execute(const TakePose& pose, std::uint64_t tick) {
  return follower_.MoveTo(pose.name, pose.speed, tick);
}

std::optional<Refusal> SimulatedRobot::Execute(const FollowTrajectory& follow, std::uint64_t tick) {
  return follower_.Follow(follow.trajectory, tick);
}

std::optional<Refusal> SimulatedRobot::Execute(const ShowRobot& show) {
  is_shown_ = show.is_shown;
  return std::nullopt;
}

std::optional<Refusal> SimulatedRobot::Execute(const Face& face) {
  face_expression_ = face.face_expression;
  return std::nullopt;
}

SimulatedRobotState SimulatedRobot::Save() const {
  // Joint positions and velocities are part of the snapshot of physics.
  return {.body = body_.state(),
          .follower = follower_.state(),
          .is_shown = is_shown_,
          .face_expression = face_expression_};
}

void SimulatedRobot::Restore(const SimulatedRobotState& state) {
  body_.Restore(state.body);
  follower_.Restore(state.follower);
  is_shown_ = state.is_shown;
  face_expression_ = state.face_expression;
}

void SimulatedRobot::AddToHash(StateHash* hash) const {
  // The articulation is hashed by physics; appearance has no effect on the future.
  for (const world::GripperState& gripper : body_.state().grippers) {
    hash->Add(gripper.opening_velocity);
    for (physics::JointId weld : gripper.welds) hash->Add(std::uint64_t{weld.value});
  }
  follower_.AddToHash(hash);
}

}  // namespace smile::sim
