#include "physics/articulation.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "base/state_hash.h"
#include "math/principal_inertia.h"
#include "mechanics/link_trees.h"
#include "physics/internal_articulation_links.h"
#include "physics/internal_collision_object.h"

// A robot as Bullet's multibodies (Featherstone, reduced coordinates), with drives of our own. In
// kinematic articulations the same links are kinematic rigid bodies, placed by forward kinematics:
// they push and cannot be pushed.

namespace smile::physics {
namespace {

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
    : id_(id), spec_(std::move(spec)), motors_(spec_, config), links_(std::make_unique<Links>()) {
  const int count = num_joints();
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

/// Makes the multibodies, and assigns the links to them. Links at the base that a coupling connects
/// share one, since a row of Bullet's solver couples joints of one.
void Articulation::MakeTrees() {
  const auto [places, tree_sizes] = mechanics::TreesOf(spec_->links);
  // The base needs one in any case.
  const std::vector<int> sizes = tree_sizes.empty() ? std::vector<int>{0} : tree_sizes;
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
  for (int i = 0; i < num_joints(); ++i) {
    links_->links[i].tree = links_->trees[places[i].tree].get();
    links_->links[i].index = places[i].index;
  }
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

void Articulation::SetVelocityTarget(int joint, double velocity) {
  motors_.SetVelocityTarget(joint, velocity, positions());
}

void Articulation::HoldStill(int joint) { motors_.HoldStill(joint, positions()); }

void Articulation::SetPositions(std::span<const int> joints, std::span<const double> positions) {
  std::vector<double> q = this->positions();
  for (const int joint : motors_.Place(joints, positions, q)) {
    links_->links[joint].SetPosition(q[joint]);
    links_->links[joint].SetVelocity(0);
  }
  UpdateLinkTransforms();
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
  // Asked in each step: while a motion is commanded, no positions need to be collected.
  const auto is_motion = [](double velocity) { return velocity != 0; };
  if (std::ranges::any_of(velocity_targets(), is_motion)) return false;
  return motors_.is_at_rest(positions(), velocities());
}

void Articulation::Save(ByteWriter* out) const {
  for (int i = 0; i < num_joints(); ++i) {
    out->Put(static_cast<double>(links_->links[i].position()));
    out->Put(static_cast<double>(links_->links[i].velocity()));
    motors_.Save(i, out);
  }
  for (int i = -1; i < num_joints(); ++i) {
    // -1 is the base, which may have no collider.
    if (const auto* collider = links_->collider(i)) SaveObject(*collider, out);
  }
}

void Articulation::Restore(ByteReader* in) {
  // Computing where the links are takes far longer than seeing that the robot stands still.
  ByteWriter present(/*room=*/in->remaining());
  Save(&present);
  if (in->SkipIfNext(present.bytes())) return;
  for (int i = 0; i < num_joints(); ++i) {
    links_->links[i].SetPosition(in->Get<double>());
    links_->links[i].SetVelocity(in->Get<double>());
    motors_.Restore(i, in);
  }
  UpdateLinkTransforms();
  for (int i = -1; i < num_joints(); ++i) {
    if (auto* collider = links_->collider(i)) RestoreObject(in, collider);
  }
}

void Articulation::AddTo(StateHash* hash) const {
  hash->Add(positions());
  hash->Add(velocities());
  motors_.AddTo(hash);
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
  const std::span<const double> q = motors_.position_references();
  for (int i = 0; i < num_joints(); ++i) links_->links[i].SetPosition(q[i]);
  UpdateLinkTransforms();
}

void Articulation::DriveKinematicLinks(double step_seconds) {
  const std::vector<double> q = positions();
  motors_.AdvanceKinematic(q, step_seconds);
  for (int i = 0; i < num_joints(); ++i) {
    links_->links[i].SetVelocity((motors_.position_references()[i] - q[i]) / step_seconds);
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
  return scene::LinkPoses(spec_->links, spec_->X_WBase, motors_.position_references());
}

void Articulation::DriveMotors(double step_seconds, double gravity) {
  const std::vector<mechanics::DriveTarget> targets = motors_.Drive(positions(), step_seconds);
  for (int i = 0; i < num_joints(); ++i) {
    const Links::Link& own = links_->links[i];
    own.drive->SetTarget(targets[i].velocity, targets[i].max_impulse);
    // Gravity compensation.
    own.tree->addLinkForce(own.index, btVector3(0, 0, gravity * spec_->links[i].mass));
  }
}

}  // namespace smile::physics
