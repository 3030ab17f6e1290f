// Commands of the robot. Each is checked completely before it changes anything; commands of joints
// end the trajectories that these follow.

#include "sim/simulated_robot.h"

#include <array>
#include <string_view>
#include <utility>

#include "base/wording.h"

namespace smile::sim {

SimulatedRobot::SimulatedRobot(physics::World* world, std::shared_ptr<const model::Model> model)
    : body_(world, std::move(model)), follower_(&body_) {}

std::optional<Refusal> SimulatedRobot::RefuseValues(
    const std::optional<std::vector<double>>& values, int arm) const {
  if (!values) return std::nullopt;
  if (arm >= body_.num_arms()) return "the robot has no such arm";
  const robot::Arm& which = body_.model().arms[arm];
  if (values->size() == which.joints.size()) return std::nullopt;
  return "the " + which.name + " arm has " + std::to_string(which.joints.size()) +
         " joints, found " + std::to_string(values->size()) + " numbers";
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

/// In commands, arm 0 is left and arm 1 is right.
std::optional<Refusal> SimulatedRobot::Execute(const JointVelocities& velocities) {
  if (auto refusal = RefuseValues(velocities.left, 0)) return refusal;
  if (auto refusal = RefuseValues(velocities.right, 1)) return refusal;
  // Everything is checked; from here on nothing can be refused.
  const std::array arms{&velocities.left, &velocities.right};
  for (int arm = 0; arm < 2; ++arm) {
    if (!*arms[arm]) continue;
    StopFollowingWithArm(arm);
    body_.SetArmVelocities(arm, **arms[arm]);
  }
  for (int arm = 0; velocities.grippers && arm < body_.num_arms() && arm < 2; ++arm) {
    StopFollowingWithGripper(arm);
    body_.SetGripperVelocity(arm, (*velocities.grippers)[arm]);
  }
  if (velocities.head) {
    StopFollowingWithHead();
    body_.SetHeadVelocity(*velocities.head);
  }
  return std::nullopt;
}

std::optional<Refusal> SimulatedRobot::Execute(const JointAngles& angles) {
  if (auto refusal = RefuseValues(angles.left, 0)) return refusal;
  if (auto refusal = RefuseValues(angles.right, 1)) return refusal;
  // Sets the angles at once, without motion; held objects move along.
  const std::array arms{&angles.left, &angles.right};
  for (int arm = 0; arm < 2; ++arm) {
    if (!*arms[arm]) continue;
    StopFollowingWithArm(arm);
    body_.SetArmAngles(arm, **arms[arm]);
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
  using enum MoveGripper::Which;
  for (int arm = 0; arm < 2; ++arm) {
    if (move.which == (arm == 0 ? kRight : kLeft)) continue;
    // Both grippers are checked before either of them moves.
    if (arm >= body_.num_arms() || !body_.model().arms[arm].gripper) {
      return "the robot has no gripper there";
    }
  }
  for (int arm = 0; arm < 2; ++arm) {
    if (move.which == (arm == 0 ? kRight : kLeft)) continue;
    StopFollowingWithGripper(arm);
    body_.SetGripperVelocity(arm, move.velocity);
  }
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
