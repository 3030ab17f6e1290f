#include "physics/articulation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/state_hash.h"
#include "math/principal_inertia.h"
#include "physics/internal_articulation_links.h"
#include "physics/internal_collision_object.h"

// A robot as Bullet's multibodies (Featherstone, reduced coordinates), with drives of our own. In
// kinematic articulations the same links are kinematic rigid bodies, placed by forward kinematics:
// they push and cannot be pushed.

namespace smile::physics {
namespace {

/// A joint below this speed and this close to its reference is at rest [rad/s or m/s; rad or m].
constexpr double kRest = 1e-7;

/// Fraction of the error of a coupling that is corrected in each physics step. It may be more than
/// that of motors, since nothing that gives way is behind it.
constexpr double kCouplingGain = 0.5;

/// Returns a rotation as Bullet's quaternion.
btQuaternion QuaternionOf(const Matrix3& R) {
  btQuaternion q;
  ToBullet(R).getRotation(q);
  return q;
}

}  // namespace

/// Builds the multibodies in four steps: trees, links with joints, then colliders, then motors.
Articulation::Articulation(ArticulationId id, std::shared_ptr<const scene::ArticulationSpec> spec,
                           const MotorConfig& config)
    : id_(id), spec_(std::move(spec)), config_(config), links_(std::make_unique<Links>()) {
  const int count = num_joints();
  velocity_targets_.assign(count, 0.0);
  position_references_.assign(count, 0.0);
  is_overloaded_.assign(count, false);
  links_->links.resize(count);
  MakeTrees();
  for (int i = 0; i < count; ++i) AddBulletLink(i);
  for (const auto& tree : links_->trees) tree->finalizeMultiDof();
  MakeColliders();
  for (int i = 0; i < count && !spec_->is_kinematic; ++i) {
    Links::Link& link = links_->links[i];
    std::optional<JointLeader> leader;
    if (const auto& mimic = spec_->links[i].mimic) {
      leader = JointLeader{links_->links[mimic->leader].index, mimic->multiplier};
    }
    link.drive = std::make_unique<JointDrive>(link.tree, link.index, leader);
  }
  std::vector<int> joints(count);
  std::iota(joints.begin(), joints.end(), 0);
  SetPositions(joints, std::vector<double>(count, 0.0));
}

/// Makes a multibody for each link at the base, and assigns the links to them. Links at the base
/// that a coupling connects share one, since a row of Bullet's solver couples joints of one.
void Articulation::MakeTrees() {
  // The link at the base that carries each link; then, of those that are coupled, the first one.
  std::vector<int> root_of(num_joints());
  for (int i = 0; i < num_joints(); ++i) {
    const int parent = spec_->links[i].parent;
    root_of[i] = parent < 0 ? i : root_of[parent];
  }
  for (int i = 0; i < num_joints(); ++i) {
    if (!spec_->links[i].mimic) continue;
    const int own = root_of[i], other = root_of[spec_->links[i].mimic->leader];
    std::ranges::replace(root_of, std::max(own, other), std::min(own, other));
  }
  std::vector<int> sizes;
  std::vector<int> tree_of(num_joints());
  for (int i = 0; i < num_joints(); ++i) {
    const bool is_first = root_of[i] == i;
    tree_of[i] = is_first ? static_cast<int>(sizes.size()) : tree_of[root_of[i]];
    if (is_first) sizes.push_back(0);
    links_->links[i].index = sizes[tree_of[i]]++;
  }
  // The base needs one in any case.
  if (sizes.empty()) sizes.push_back(0);
  for (const int size : sizes) {
    // The base is fixed, so its mass and inertia have no effect.
    auto tree = std::make_unique<btMultiBody>(size, /*mass=*/1.0, btVector3(1, 1, 1),
                                              /*fixedBase=*/true, /*canSleep=*/false);
    tree->setBaseWorldTransform(ToBullet(spec_->X_WBase));
    tree->setHasSelfCollision(true);
    tree->setUseGyroTerm(true);
    // Damping would change the speed that a motor commands; motors hold the joints instead.
    tree->setLinearDamping(0);
    tree->setAngularDamping(0);
    // Marks trees of the same articulation: see ExactWorld.
    tree->setUserIndex(static_cast<int>(id_.value));
    links_->trees.push_back(std::move(tree));
  }
  for (int i = 0; i < num_joints(); ++i) links_->links[i].tree = links_->trees[tree_of[i]].get();
}

/// Adds a link to its multibody. Bullet wants each link in the frame of its center of mass and
/// principal axes (Lcm), relative to that of its parent (Pcm).
void Articulation::AddBulletLink(int number) {
  const scene::LinkSpec& link = spec_->links[number];
  Links::Link& own = links_->links[number];
  // Bullet takes only the diagonal of an inertia, so the frame is rotated to the principal axes.
  const PrincipalInertia inertia = PrincipalInertiaOf(link.inertia);
  const RigidTransform X_LLcm(inertia.axes, link.p_LLcm);
  own.X_LLcm = X_LLcm;
  const RigidTransform X_PPcm =
      link.parent < 0 ? RigidTransform() : links_->links[link.parent].X_LLcm;

  // At q = 0 the link frame L coincides with the joint frame J.
  const Matrix3 R_LcmPcm =
      (X_PPcm.rotation().transpose() * link.X_PJ.rotation() * X_LLcm.rotation()).transpose();
  const Vector3 axis_in_Lcm = X_LLcm.rotation().transpose() * link.axis;
  const Vector3 p_PcmJ_Pcm = X_PPcm.inverse() * link.X_PJ.translation();
  const Vector3 p_LLcm_Lcm = X_LLcm.rotation().transpose() * link.p_LLcm;
  const auto set_up = [&](auto method) {
    const int parent = link.parent < 0 ? -1 : links_->links[link.parent].index;
    (own.tree->*method)(own.index, link.mass, ToBullet(inertia.moments), parent,
                        QuaternionOf(R_LcmPcm), ToBullet(axis_in_Lcm), ToBullet(p_PcmJ_Pcm),
                        ToBullet(p_LLcm_Lcm), /*disableParentCollision=*/true);
  };
  link.joint_type == scene::JointType::kRevolute ? set_up(&btMultiBody::setupRevolute)
                                                 : set_up(&btMultiBody::setupPrismatic);
  btMultibodyLink& bullet = own.tree->getLink(own.index);
  bullet.m_jointLowerLimit = link.lower;
  bullet.m_jointUpperLimit = link.upper;
  bullet.m_jointMaxVelocity = link.max_velocity;
}

void Articulation::MakeColliders() {
  if (!spec_->base_solids.empty()) {
    links_->base_collision = MakeCollisionShape(spec_->base_solids, RigidTransform());
    links_->base_collider = MakeCollider(-1);
    links_->base_collider->setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
    SetPose(spec_->X_WBase, links_->base_collider.get());
  }
  for (int i = 0; i < num_joints(); ++i) {
    Links::Link& link = links_->links[i];
    // Links without solids also get a collider: Bullet finds the drive of a joint by it.
    link.collision = MakeCollisionShape(spec_->links[i].solids, link.X_LLcm.inverse());
    link.collider = MakeCollider(i);
  }
}

std::unique_ptr<btCollisionObject> Articulation::MakeCollider(int link) {
  const bool is_base = link < 0;
  btCollisionShape* shape =
      is_base ? links_->base_collision.shape() : links_->links[link].collision.shape();
  std::unique_ptr<btCollisionObject> collider;
  if (spec_->is_kinematic) {
    auto kinematic = std::make_unique<btRigidBody>(/*mass=*/0, /*motionState=*/nullptr, shape);
    if (!is_base) MakeKinematic(kinematic.get());
    collider = std::move(kinematic);
  } else {
    btMultiBody& tree = is_base ? *links_->trees.front() : *links_->links[link].tree;
    const int index = is_base ? -1 : links_->links[link].index;
    auto of_multibody = std::make_unique<btMultiBodyLinkCollider>(&tree, index);
    of_multibody->setCollisionShape(shape);
    if (is_base) {
      tree.setBaseCollider(of_multibody.get());
    } else {
      tree.getLink(index).m_collider = of_multibody.get();
    }
    collider = std::move(of_multibody);
  }
  collider->setFriction(is_base ? scene::LinkSpec().friction : spec_->links[link].friction);
  // The base has the articulation's own number in the order, links the numbers after it.
  collider->setUserIndex(static_cast<int>(id_.value) + 1 + link);
  return collider;
}

Articulation::~Articulation() = default;

std::vector<double> Articulation::positions() const {
  std::vector<double> q(num_joints());
  for (int i = 0; i < num_joints(); ++i) q[i] = links_->links[i].position();
  return q;
}

std::vector<double> Articulation::velocities() const {
  std::vector<double> v(num_joints());
  for (int i = 0; i < num_joints(); ++i) v[i] = links_->links[i].velocity();
  return v;
}

std::vector<RigidTransform> Articulation::link_poses() const {
  return scene::LinkPoses(spec_->links, spec_->X_WBase, positions());
}

void Articulation::CheckJoint(int joint) const {
  if (joint < 0 || joint >= num_joints()) {
    throw std::invalid_argument("joint is " + std::to_string(joint) + ", expected 0 to " +
                                std::to_string(num_joints() - 1));
  }
}

double Articulation::MaxLead(int joint) const {
  return spec_->links[joint].joint_type == scene::JointType::kRevolute ? config_.max_lead_angle
                                                                       : config_.max_lead_length;
}

void Articulation::SetVelocityTarget(int joint, double velocity) {
  CheckJoint(joint);
  const scene::LinkSpec& link = spec_->links[joint];
  if (!std::isfinite(velocity)) {
    throw std::invalid_argument(link.joint_name + ": velocity is not finite");
  }
  if (link.mimic) {
    throw std::invalid_argument(link.joint_name + ": it mimics " +
                                spec_->links[link.mimic->leader].joint_name +
                                ", expected a joint with a motor");
  }
  const double target = std::clamp(velocity, -link.max_velocity, link.max_velocity);
  // A lead above half its bound means that the joint is blocked; ordinary lag is smaller.
  const double lead = position_references_[joint] - links_->links[joint].position();
  const bool is_blocked = std::abs(lead) > MaxLead(joint) / 2;
  // Drops the lead when a blocked joint is commanded to stop or reverse: it would continue to push
  // until the reference had come back.
  if (is_blocked && target != velocity_targets_[joint] && lead * target <= 0) HoldStill(joint);
  velocity_targets_[joint] = target;
}

void Articulation::HoldStill(int joint) {
  CheckJoint(joint);
  velocity_targets_[joint] = 0;
  position_references_[joint] = links_->links[joint].position();
}

/// Moves references along with the joints: otherwise motors would pull them back.
void Articulation::SetPositions(std::span<const int> joints, std::span<const double> positions) {
  if (positions.size() != joints.size()) {
    throw std::invalid_argument("positions are " + std::to_string(positions.size()) +
                                ", expected one for each of " + std::to_string(joints.size()) +
                                " joints");
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    CheckJoint(joints[i]);
    const scene::LinkSpec& link = spec_->links[joints[i]];
    if (!std::isfinite(positions[i])) {
      throw std::invalid_argument(link.joint_name + ": position is not finite");
    }
    PutJoint(joints[i], std::clamp(positions[i], link.lower, link.upper));
  }
  std::vector<double> q = this->positions();
  scene::FollowLeaders(spec_->links, q);
  for (int i = 0; i < num_joints(); ++i) {
    const auto& mimic = spec_->links[i].mimic;
    const bool is_moved = mimic && std::ranges::count(joints, mimic->leader) > 0;
    if (is_moved || (mimic && std::ranges::count(joints, i) > 0)) PutJoint(i, q[i]);
  }
  UpdateLinkTransforms();
}

/// Puts a joint at a position, at rest.
void Articulation::PutJoint(int joint, double q) {
  position_references_[joint] = q;
  links_->links[joint].SetPosition(q);
  links_->links[joint].SetVelocity(0);
}

void Articulation::UpdateLinkTransforms() {
  if (spec_->is_kinematic) {
    const std::vector<RigidTransform> X_WL = link_poses();
    for (int i = 0; i < num_joints(); ++i) {
      const Links::Link& link = links_->links[i];
      if (link.collider) SetPose(X_WL[i] * link.X_LLcm, link.collider.get());
    }
    return;
  }
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> origins;
  for (const auto& tree : links_->trees) {
    tree->forwardKinematics(rotations, origins);
    tree->updateCollisionObjectWorldTransforms(rotations, origins);
  }
}

bool Articulation::is_at_rest() const {
  for (int i = 0; i < num_joints(); ++i) {
    if (velocity_targets_[i] != 0 || std::abs(links_->links[i].velocity()) > kRest ||
        std::abs(links_->links[i].position() - position_references_[i]) > kRest) {
      return false;
    }
  }
  return true;
}

void Articulation::Save(ByteWriter* out) const {
  for (int i = 0; i < num_joints(); ++i) {
    out->Put(static_cast<double>(links_->links[i].position()));
    out->Put(static_cast<double>(links_->links[i].velocity()));
    out->Put(velocity_targets_[i]);
    out->Put(position_references_[i]);
  }
  for (int i = -1; i < num_joints(); ++i) {
    // -1 is the base, which may have no collider.
    if (const auto* collider = links_->collider(i)) SaveObject(*collider, out);
  }
}

void Articulation::Restore(ByteReader* in) {
  for (int i = 0; i < num_joints(); ++i) {
    links_->links[i].SetPosition(in->Get<double>());
    links_->links[i].SetVelocity(in->Get<double>());
    velocity_targets_[i] = in->Get<double>();
    position_references_[i] = in->Get<double>();
  }
  UpdateLinkTransforms();
  for (int i = -1; i < num_joints(); ++i) {
    if (auto* collider = links_->collider(i)) RestoreObject(in, collider);
  }
}

void Articulation::AddTo(StateHash* hash) const {
  // Overloads are not hashed: each step sets them before it uses them.
  hash->Add(positions());
  hash->Add(velocities());
  hash->Add(velocity_targets_);
  hash->Add(position_references_);
}

void Articulation::BeforeStep(double step_seconds, double gravity) {
  if (spec_->is_kinematic) {
    DriveKinematicLinks(step_seconds);
  } else {
    DriveMotors(step_seconds, gravity);
  }
}

void Articulation::AfterStep() {
  if (!spec_->is_kinematic) return;
  for (int i = 0; i < num_joints(); ++i) links_->links[i].SetPosition(position_references_[i]);
  UpdateLinkTransforms();
}

/// Marks all joints from the link to the base: each of them bears its weight.
void Articulation::NoteOverload(int link) {
  for (int i = link; i >= 0; i = spec_->links[i].parent) is_overloaded_[i] = true;
}

void Articulation::DriveKinematicLinks(double step_seconds) {
  for (int i = 0; i < num_joints(); ++i) {
    const scene::LinkSpec& link = spec_->links[i];
    const double q = links_->links[i].position();
    position_references_[i] =
        std::clamp(q + velocity_targets_[i] * step_seconds, link.lower, link.upper);
  }
  scene::FollowLeaders(spec_->links, position_references_);
  for (int i = 0; i < num_joints(); ++i) {
    const double q = links_->links[i].position();
    links_->links[i].SetVelocity((position_references_[i] - q) / step_seconds);
  }
  // Velocities for Bullet: contacts see links that move, although the links are placed by
  // AfterStep().
  const std::vector<RigidTransform> X_WNow = link_poses(), X_WNext = next_link_poses();
  for (int i = 0; i < num_joints(); ++i) {
    const Links::Link& link = links_->links[i];
    if (!link.collider) continue;
    btRigidBody* object = btRigidBody::upcast(link.collider.get());
    const bool moves = !(X_WNext[i] == X_WNow[i]);
    // Bodies in contact with a link that stands still may fall asleep.
    object->forceActivationState(moves ? DISABLE_DEACTIVATION : ISLAND_SLEEPING);
    if (moves) {
      SetVelocityToReach(X_WNext[i] * link.X_LLcm, step_seconds, object);
    } else {
      object->setLinearVelocity(btVector3(0, 0, 0));
      object->setAngularVelocity(btVector3(0, 0, 0));
    }
  }
}

std::vector<RigidTransform> Articulation::next_link_poses() const {
  return scene::LinkPoses(spec_->links, spec_->X_WBase, position_references_);
}

void Articulation::DriveMotors(double step_seconds, double gravity) {
  for (int i = 0; i < num_joints(); ++i) {
    const scene::LinkSpec& link = spec_->links[i];
    const Links::Link& own = links_->links[i];
    link.mimic ? DriveCoupling(i, step_seconds) : DriveMotor(i, step_seconds);
    // Gravity compensation.
    own.tree->addLinkForce(own.index, btVector3(0, 0, gravity * link.mass));
  }
  // Noted again before each step, as long as a weld bears too much.
  is_overloaded_.assign(is_overloaded_.size(), false);
}

void Articulation::DriveMotor(int joint, double step_seconds) {
  const scene::LinkSpec& link = spec_->links[joint];
  const Links::Link& own = links_->links[joint];
  const double q = own.position();
  const double max_lead = MaxLead(joint);
  // The reference advances with the commanded speed, but leads the joint by a bounded amount only,
  // and stays within the limits.
  const double wanted = position_references_[joint] + velocity_targets_[joint] * step_seconds;
  const double reference =
      std::clamp(std::clamp(wanted, q - max_lead, q + max_lead), link.lower, link.upper);
  // At a limit or when blocked, the reference stops, and so does the commanded speed.
  const double speed = reference == wanted
                           ? velocity_targets_[joint]
                           : (reference - position_references_[joint]) / step_seconds;
  position_references_[joint] = reference;

  // Velocity feedforward plus proportional correction; the solver provides the force, up to the
  // effort.
  const double return_speed = config_.position_gain * (reference - q) / step_seconds;
  const double effort = link.max_effort * (is_overloaded_[joint] ? 1.0 : config_.effort_scale);
  own.drive->SetTarget(speed + return_speed, effort * step_seconds);
}

/// A coupling keeps the ratio of velocities, and corrects what remains of errors of position.
void Articulation::DriveCoupling(int joint, double step_seconds) {
  const scene::Mimic& mimic = *spec_->links[joint].mimic;
  const Links::Link& own = links_->links[joint];
  const double q = own.position();
  const double reference = mimic.multiplier * links_->links[mimic.leader].position() + mimic.offset;
  position_references_[joint] = reference;
  own.drive->SetTarget(kCouplingGain * (reference - q) / step_seconds, 0);
}

}  // namespace smile::physics
