#include "world/robot_body.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "robot/kinematics.h"
#include "world/grasp_rule.h"

// The robot in the physics world. Arms and head are driven by velocity. A gripper either attaches
// what it has grasped (a weld, the default) or holds by friction, depending on options of the
// robot.

namespace smile::world {
namespace {

void CheckCount(std::span<const double> values, std::size_t expected, const std::string& arm) {
  if (values.size() == expected) return;
  throw std::invalid_argument(arm + " arm: " + std::to_string(values.size()) +
                              " values, expected " + std::to_string(expected));
}

/// Friction of a finger that holds by friction, like rubber. Blocks have 0.6, and Bullet
/// multiplies.
constexpr double kPadFriction = 1.5;

/// Friction of fingers that attach what they grasp. Smooth, so that an object rotates until it lies
/// flat between them, as with soft pads.
constexpr double kSmoothFriction = 0;

void SmoothFingers(const robot::RobotModel& model, scene::ArticulationSpec* spec) {
  for (const robot::Arm& arm : model.arms) {
    if (!arm.gripper) continue;
    spec->links[arm.gripper->left_finger].friction = kSmoothFriction;
    spec->links[arm.gripper->right_finger].friction = kSmoothFriction;
  }
}

/// Sets up fingers that hold by friction: the left one keeps its place with the full effort of its
/// motor, and the right one presses with the effort that its description names.
void PadFingers(const robot::RobotModel& model, double effort_scale,
                scene::ArticulationSpec* spec) {
  for (const robot::Arm& arm : model.arms) {
    if (!arm.gripper) continue;
    spec->links[arm.gripper->left_finger].friction = kPadFriction;
    spec->links[arm.gripper->right_finger].friction = kPadFriction;
    // Motors of all joints have more effort than described, by this factor; the pressing finger has
    // exactly the described one.
    spec->links[arm.gripper->right_finger].max_effort /= effort_scale;
  }
}

}  // namespace

RobotBody::RobotBody(physics::World* world, std::shared_ptr<const model::Model> shared_model)
    : world_(world), model_(std::move(shared_model)) {
  if (model_->robot() == nullptr) throw std::invalid_argument("the model has no robot");
  if (options().is_kinematic && options().grasps_by_friction) {
    throw std::invalid_argument("a kinematic robot can't grasp by friction");
  }
  scene::ArticulationSpec spec = robot::MakeArticulationSpec(model(), base_pose());
  spec.is_kinematic = options().is_kinematic;
  if (options().grasps_by_friction) {
    PadFingers(model(), world_->config().motor.effort_scale, &spec);
  } else {
    SmoothFingers(model(), &spec);
  }
  articulation_ = world_->AddArticulation(spec);
  std::vector<int> joints(model().num_joints());
  std::iota(joints.begin(), joints.end(), 0);
  articulation().SetPositions(joints, model().q_start);
  state_.grippers.resize(model().arms.size());
}

void RobotBody::SetArmVelocities(int arm, std::span<const double> velocities) {
  const robot::Arm& which = model().arms.at(arm);
  CheckCount(velocities, which.joints.size(), which.name);
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    articulation().SetVelocityTarget(which.joints[i], velocities[i]);
  }
}

void RobotBody::SetGripperVelocity(int arm, double velocity) {
  if (!model().arms.at(arm).gripper) return;
  state_.grippers[arm].opening_velocity = velocity;
  if (velocity > 0) Release(arm);
  CommandFingers(arm);
}

/// Commands the fingers, which share the motion. A gripper that holds an attached object keeps its
/// opening. If it squeezes an object, the left finger stays: if both pressed, nothing would keep
/// the object from moving with them.
void RobotBody::CommandFingers(int arm) {
  const robot::Gripper& gripper = *model().arms[arm].gripper;
  const GripperState& state = state_.grippers[arm];
  // Each finger moves by half of the opening.
  const double velocity = state.welds.empty() ? state.opening_velocity / 2 : 0.0;
  articulation().SetVelocityTarget(gripper.right_finger, velocity);
  if (options().grasps_by_friction && velocity < 0 && IsSqueezing(gripper)) {
    // Once only: HoldStill() takes the present position as its target, which must not creep.
    const bool moves = articulation().velocity_targets()[gripper.left_finger] != 0;
    if (moves) articulation().HoldStill(gripper.left_finger);
  } else {
    articulation().SetVelocityTarget(gripper.left_finger, velocity);
  }
}

bool RobotBody::IsSqueezing(const robot::Gripper& gripper) const {
  const auto left = world_->ContactsWith(articulation_, gripper.left_finger);
  const auto right = world_->ContactsWith(articulation_, gripper.right_finger);
  return std::any_of(left.begin(), left.end(), [&right](const physics::Contact& a) {
    return std::any_of(right.begin(), right.end(),
                       [&a](const physics::Contact& b) { return b.body == a.body; });
  });
}

void RobotBody::SetJointVelocity(int joint, double velocity) {
  articulation().SetVelocityTarget(joint, velocity);
}

void RobotBody::SetHeadVelocity(double velocity) {
  if (model().head) articulation().SetVelocityTarget(model().head->joint, velocity);
}

void RobotBody::SetArmAngles(int arm, std::span<const double> angles) {
  const robot::Arm& which = model().arms.at(arm);
  CheckCount(angles, which.joints.size(), which.name);
  articulation().SetPositions(which.joints, angles);

  // Held bodies move with their links, at once.
  const std::vector<RigidTransform> X_WL = articulation().link_poses();
  const std::vector<physics::JointId>& welds = state_.grippers[arm].welds;
  for (const physics::Joint& joint : world_->joints()) {
    if (std::find(welds.begin(), welds.end(), joint.id) == welds.end()) continue;
    const auto& weld = std::get<physics::WeldSpec>(joint.spec);
    world_->MoveAssembly(weld.body, X_WL[weld.link] * weld.X_LB);
  }
  // Bodies that sleep on or against the robot must notice that it is elsewhere.
  world_->WakeAll();
}

void RobotBody::SetHeadAngle(double angle) {
  if (!model().head) return;
  articulation().SetPositions(std::span(&model().head->joint, 1), std::span(&angle, 1));
  world_->WakeAll();
}

void RobotBody::AfterStep() {
  for (int arm = 0; arm < num_arms(); ++arm) {
    const GripperState& state = state_.grippers[arm];
    // Only grippers that are closing and hold nothing yet.
    if (state.opening_velocity >= 0 || !state.welds.empty()) continue;
    if (options().grasps_by_friction) {
      CommandFingers(arm);
    } else {
      CloseAround(arm);
    }
  }
}

void RobotBody::CloseAround(int arm) {
  const robot::Gripper& gripper = *model().arms[arm].gripper;
  const auto left = world_->ContactsWith(articulation_, gripper.left_finger);
  const auto right = world_->ContactsWith(articulation_, gripper.right_finger);
  // The common case while closing: nothing to compute.
  if (left.empty() || right.empty()) return;

  // Welded to the palm and not to a finger, so that forces on the object do not open the gripper.
  const int palm = model().frames[model().arms[arm].tool].link;
  const RigidTransform X_LW = articulation().link_poses()[palm].inverse();
  double payload = model().arms[arm].payload;
  for (physics::BodyId id : GraspedBodies(left, right, ToolPose(arm), GripperOpening(arm))) {
    const physics::Body& body = world_->body(id);
    // A body held by a hand or the other gripper is not taken from it.
    if (body.is_static() || body.is_carried()) continue;
    state_.grippers[arm].welds.push_back(world_->AddJoint(
        physics::WeldSpec{.articulation = articulation_,
                          .link = palm,
                          .body = id,
                          .X_LB = X_LW * body.pose_in_world(),
                          .links_not_colliding = {palm, gripper.left_finger, gripper.right_finger},
                          .holds_up = payload}));
    // Several bodies share the payload.
    payload = std::max(0.0, payload - body.spec().mass.mass);
  }
  if (state_.grippers[arm].welds.empty()) return;
  articulation().HoldStill(gripper.left_finger);
  articulation().HoldStill(gripper.right_finger);
}

void RobotBody::Release(int arm) {
  for (physics::JointId weld : std::exchange(state_.grippers[arm].welds, {})) {
    for (const physics::Joint& joint : world_->joints()) {
      if (joint.id != weld) continue;
      const physics::BodyId held = std::get<physics::WeldSpec>(joint.spec).body;
      world_->RemoveJoint(weld);
      // A released body starts at rest, like one released by a hand.
      world_->body(held).SetVelocity(Vector3::Zero(), Vector3::Zero());
      break;
    }
  }
}

std::vector<double> RobotBody::ArmAngles(int arm) const {
  const std::vector<double> q = positions();
  std::vector<double> angles;
  for (int joint : model().arms.at(arm).joints) angles.push_back(q[joint]);
  return angles;
}

std::vector<double> RobotBody::ArmVelocities(int arm) const {
  const std::vector<double> v = articulation().velocities();
  std::vector<double> velocities;
  for (int joint : model().arms.at(arm).joints) velocities.push_back(v[joint]);
  return velocities;
}

double RobotBody::HeadAngle() const {
  return model().head ? positions()[model().head->joint] : 0.0;
}

double RobotBody::GripperOpening(int arm) const {
  const auto& gripper = model().arms.at(arm).gripper;
  if (!gripper) return 0.0;
  const std::vector<double> q = positions();
  return q[gripper->left_finger] + q[gripper->right_finger] + gripper->closed_opening;
}

RigidTransform RobotBody::ToolPose(int arm) const {
  return robot::FramePose(model(), base_pose(), positions(), model().arms.at(arm).tool);
}

std::vector<physics::BodyId> RobotBody::HeldBodies(int arm) const {
  std::vector<physics::BodyId> held;
  for (physics::JointId weld : state_.grippers.at(arm).welds) {
    for (const physics::Joint& joint : world_->joints()) {
      if (joint.id == weld) held.push_back(std::get<physics::WeldSpec>(joint.spec).body);
    }
  }
  return held;
}

bool RobotBody::IsTouching(const std::vector<physics::BodyId>& bodies) const {
  for (int link = -1; link < model().num_joints(); ++link) {  // -1: the base
    for (const physics::Contact& contact : world_->ContactsWith(articulation_, link)) {
      if (std::ranges::find(bodies, contact.body) != bodies.end()) return true;
    }
  }
  return false;
}

std::vector<double> RobotBody::positions() const { return articulation().positions(); }

}  // namespace smile::world
