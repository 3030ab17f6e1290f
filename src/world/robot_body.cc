#include "world/robot_body.h"

#include <algorithm>
#include <iterator>
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

/// Returns true if an arm has a gripper that closes on bodies from two sides.
bool HasSides(const robot::Arm& arm) {
  return arm.gripper && arm.gripper->kind != robot::GripperKind::kSuction;
}

void SmoothFingers(const robot::RobotModel& model, scene::ArticulationSpec* spec) {
  for (const robot::Arm& arm : model.arms) {
    if (!HasSides(arm)) continue;
    spec->links[arm.gripper->left_finger].friction = kSmoothFriction;
    spec->links[arm.gripper->right_finger].friction = kSmoothFriction;
  }
}

/// Sets up fingers that hold by friction: the left one keeps its place with the full effort of its
/// motor, and the right one presses with the effort that its description names. Jaws press with
/// that of their drive.
void PadFingers(const robot::RobotModel& model, double effort_scale,
                scene::ArticulationSpec* spec) {
  for (const robot::Arm& arm : model.arms) {
    if (!HasSides(arm)) continue;
    spec->links[arm.gripper->left_finger].friction = kPadFriction;
    spec->links[arm.gripper->right_finger].friction = kPadFriction;
    // Motors of all joints have more effort than described, by this factor; the pressing finger has
    // exactly the described one.
    const bool has_drive = arm.gripper->kind == robot::GripperKind::kJaws;
    const int pressing = has_drive ? arm.gripper->drive : arm.gripper->right_finger;
    spec->links[pressing].max_effort /= effort_scale;
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
  CommandGripper(arm);
}

void RobotBody::CommandGripper(int arm) {
  switch (model().arms[arm].gripper->kind) {
    case robot::GripperKind::kFingers:
      return CommandFingers(arm);
    case robot::GripperKind::kJaws:
      return CommandDrive(arm);
    case robot::GripperKind::kSuction:
      return;  // nothing moves
  }
}

/// Commands the drive of jaws such that the opening changes at the commanded rate. A gripper that
/// holds an attached object keeps its opening.
void RobotBody::CommandDrive(int arm) {
  const robot::Gripper& gripper = *model().arms[arm].gripper;
  const GripperState& state = state_.grippers[arm];
  const double velocity = state.welds.empty() ? state.opening_velocity : 0.0;
  articulation().SetVelocityTarget(gripper.drive,
                                   velocity * DriveRateAt(model(), gripper, positions()));
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
  return std::any_of(left.begin(), left.end(), [&right](const physics::LinkContact& a) {
    return std::any_of(right.begin(), right.end(),
                       [&a](const physics::LinkContact& b) { return b.body == a.body; });
  });
}

void RobotBody::SetJointVelocity(int joint, double velocity) {
  articulation().SetVelocityTarget(joint, velocity);
}

void RobotBody::SetHeadVelocity(double velocity) {
  const auto& head = model().head;
  if (head && !head->joints.empty()) {
    articulation().SetVelocityTarget(head->joints.front(), velocity);
  }
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
  const auto& head = model().head;
  if (!head || head->joints.empty()) return;
  articulation().SetPositions(std::span(head->joints).first(1), std::span(&angle, 1));
  world_->WakeAll();
}

void RobotBody::AfterStep() {
  for (int arm = 0; arm < num_arms(); ++arm) {
    const GripperState& state = state_.grippers[arm];
    if (state.opening_velocity == 0) continue;
    const robot::Gripper& gripper = *model().arms[arm].gripper;
    // The rate between drive and opening depends on the opening.
    if (gripper.kind == robot::GripperKind::kJaws) CommandDrive(arm);
    // Only grippers that are closing and hold nothing yet.
    if (state.opening_velocity >= 0 || !state.welds.empty()) continue;
    if (GraspsByFriction(gripper)) {
      CommandGripper(arm);
    } else {
      CloseAround(arm);
    }
  }
}

/// A suction cup has nothing to press with: it always attaches what it holds.
bool RobotBody::GraspsByFriction(const robot::Gripper& gripper) const {
  return options().grasps_by_friction && gripper.kind != robot::GripperKind::kSuction;
}

std::vector<physics::BodyId> RobotBody::BodiesIn(int arm) const {
  const robot::Gripper& gripper = *model().arms[arm].gripper;
  if (gripper.kind == robot::GripperKind::kSuction) {
    const int cup = model().frames[model().arms[arm].tool].link;
    const auto contacts = world_->ContactsWith(articulation_, cup);
    if (contacts.empty()) return {};
    const auto body = BodyAtCup(contacts, ToolPose(arm), gripper.cup_radius);
    if (!body) return {};
    double mass = 0;
    for (physics::BodyId id : world_->Assembly(*body)) mass += world_->body(id).spec().mass.mass;
    return mass <= gripper.cup_capacity ? std::vector{*body} : std::vector<physics::BodyId>();
  }
  const auto left = world_->ContactsWith(articulation_, gripper.left_finger);
  const auto right = world_->ContactsWith(articulation_, gripper.right_finger);
  // The common case while closing: nothing to compute.
  if (left.empty() || right.empty()) return {};
  return gripper.kind == robot::GripperKind::kJaws
             ? BodiesBetweenJaws(left, right)
             : GraspedBodies(left, right, ToolPose(arm), GripperOpening(arm));
}

std::vector<int> RobotBody::LinksAroundHeld(int arm) const {
  const robot::Gripper& gripper = *model().arms[arm].gripper;
  std::vector<int> links{model().frames[model().arms[arm].tool].link};
  std::ranges::copy(JointsOf(model(), gripper), std::back_inserter(links));
  return links;
}

void RobotBody::CloseAround(int arm) {
  const std::vector<physics::BodyId> grasped = BodiesIn(arm);
  if (grasped.empty()) return;
  // Welded to the palm and not to a finger, so that forces on the object do not open the gripper.
  const int palm = model().frames[model().arms[arm].tool].link;
  const RigidTransform X_LW = articulation().link_poses()[palm].inverse();
  double payload = model().arms[arm].payload;
  for (physics::BodyId id : grasped) {
    const physics::Body& body = world_->body(id);
    // A body held by a hand or the other gripper is not taken from it.
    if (body.is_static() || body.is_carried()) continue;
    state_.grippers[arm].welds.push_back(
        world_->AddJoint(physics::WeldSpec{.articulation = articulation_,
                                           .link = palm,
                                           .body = id,
                                           .X_LB = X_LW * body.pose_in_world(),
                                           .links_not_colliding = LinksAroundHeld(arm),
                                           .holds_up = payload}));
    // Several bodies share the payload.
    payload = std::max(0.0, payload - body.spec().mass.mass);
  }
  if (state_.grippers[arm].welds.empty()) return;
  for (const int joint : JointsOf(model(), *model().arms[arm].gripper)) {
    if (!model().links[joint].mimic) articulation().HoldStill(joint);
  }
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
  const auto& head = model().head;
  return head && !head->joints.empty() ? positions()[head->joints.front()] : 0.0;
}

double RobotBody::GripperOpening(int arm) const {
  const auto& gripper = model().arms.at(arm).gripper;
  return gripper ? OpeningOf(model(), *gripper, positions()) : 0.0;
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
    for (const physics::LinkContact& contact : world_->ContactsWith(articulation_, link)) {
      if (std::ranges::find(bodies, contact.body) != bodies.end()) return true;
    }
  }
  return false;
}

std::vector<double> RobotBody::positions() const { return articulation().positions(); }

}  // namespace smile::world
