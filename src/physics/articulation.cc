#include "physics/articulation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "physics/internal_articulation_links.h"

namespace smile::physics {
namespace {

constexpr double kLinkFriction = 0.6;
/// Slower than this, and nearer to its reference than this, a joint is at rest [rad or m, per s].
constexpr double kRest = 1e-7;

btQuaternion QuaternionOf(const Matrix3& R) {
  btQuaternion q;
  ToBullet(R).getRotation(q);
  return q;
}

std::unique_ptr<btMultiBodyLinkCollider> MakeCollider(btMultiBody* multibody, int link,
                                                      const CollisionShape& collision, int order) {
  auto collider = std::make_unique<btMultiBodyLinkCollider>(multibody, link);
  collider->setCollisionShape(collision.shape());
  collider->setFriction(kLinkFriction);
  collider->setUserIndex(order);
  return collider;
}

}  // namespace

Articulation::Articulation(ArticulationId id, std::shared_ptr<const ArticulationSpec> spec,
                           const MotorConfig& config)
    : id_(id), spec_(std::move(spec)), config_(config), links_(std::make_unique<Links>()) {
  const int count = num_joints();
  velocity_targets_.assign(count, 0.0);
  position_references_.assign(count, 0.0);
  bullet_ = std::make_unique<btMultiBody>(count, /*mass=*/1.0, btVector3(1, 1, 1),
                                          /*fixedBase=*/true, /*canSleep=*/false);
  links_->links.resize(count);

  for (int i = 0; i < count; ++i) {
    const LinkSpec& link = spec_->links[i];
    const PrincipalInertia inertia = PrincipalInertiaOf(link.inertia);
    RigidTransform& X_LLcm = links_->links[i].X_LLcm;
    X_LLcm = RigidTransform(inertia.axes, link.p_LLcm);
    const RigidTransform X_PPcm =
        link.parent < 0 ? RigidTransform() : links_->links[link.parent].X_LLcm;

    const Matrix3 R_LcmPcm =
        (X_PPcm.rotation().transpose() * link.X_PJ.rotation() * X_LLcm.rotation()).transpose();
    const Vector3 axis_in_Lcm = X_LLcm.rotation().transpose() * link.axis;
    const Vector3 p_PcmJ_Pcm = X_PPcm.inverse() * link.X_PJ.translation();
    const Vector3 p_LLcm_Lcm = X_LLcm.rotation().transpose() * link.p_LLcm;
    const auto set_up = [&](auto method) {
      (bullet_.get()->*method)(i, link.mass, ToBullet(inertia.moments), link.parent,
                               QuaternionOf(R_LcmPcm), ToBullet(axis_in_Lcm), ToBullet(p_PcmJ_Pcm),
                               ToBullet(p_LLcm_Lcm),
                               /*disableParentCollision=*/true);
    };
    link.joint_type == JointType::kRevolute ? set_up(&btMultiBody::setupRevolute)
                                            : set_up(&btMultiBody::setupPrismatic);
  }
  bullet_->finalizeMultiDof();
  bullet_->setBaseWorldTransform(ToBullet(spec_->X_WBase));
  bullet_->setHasSelfCollision(true);
  bullet_->setUseGyroTerm(true);
  bullet_->setLinearDamping(0);
  bullet_->setAngularDamping(0);

  // Colliders: the base takes the articulation's own number in the order, links the ones after it.
  const int order = static_cast<int>(id_.value);
  if (!spec_->base_solids.empty()) {
    links_->base_collision = MakeCollisionShape(spec_->base_solids, RigidTransform());
    links_->base_collider = MakeCollider(bullet_.get(), -1, links_->base_collision, order);
    links_->base_collider->setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
    bullet_->setBaseCollider(links_->base_collider.get());
  }
  for (int i = 0; i < count; ++i) {
    const LinkSpec& spec_of_link = spec_->links[i];
    Links::Link& link = links_->links[i];
    // Without solids, too: Bullet finds the motor of a joint by its link's collider.
    link.collision = MakeCollisionShape(spec_of_link.solids, link.X_LLcm.inverse());
    link.collider = MakeCollider(bullet_.get(), i, link.collision, order + 1 + i);
    bullet_->getLink(i).m_collider = link.collider.get();
    link.motor = std::make_unique<btMultiBodyJointMotor>(bullet_.get(), i, 0.0, 0.0);
    link.limits = std::make_unique<btMultiBodyJointLimitConstraint>(
        bullet_.get(), i, spec_of_link.lower, spec_of_link.upper);
  }
  std::vector<int> joints(count);
  std::iota(joints.begin(), joints.end(), 0);
  SetPositions(joints, std::vector<double>(count, 0.0));
}

Articulation::~Articulation() = default;

std::vector<double> Articulation::positions() const {
  std::vector<double> q(num_joints());
  for (int i = 0; i < num_joints(); ++i) q[i] = bullet_->getJointPos(i);
  return q;
}

std::vector<double> Articulation::velocities() const {
  std::vector<double> v(num_joints());
  for (int i = 0; i < num_joints(); ++i) v[i] = bullet_->getJointVel(i);
  return v;
}

std::vector<RigidTransform> Articulation::link_poses() const {
  return LinkPoses(spec_->links, spec_->X_WBase, positions());
}

void Articulation::CheckJoint(int joint) const {
  if (joint < 0 || joint >= num_joints()) {
    throw std::invalid_argument("joint is " + std::to_string(joint) + ", expected 0 to " +
                                std::to_string(num_joints() - 1));
  }
}

void Articulation::SetVelocityTarget(int joint, double velocity) {
  CheckJoint(joint);
  const LinkSpec& link = spec_->links[joint];
  if (!std::isfinite(velocity)) {
    throw std::invalid_argument(link.joint_name + ": velocity is not finite");
  }
  velocity_targets_[joint] = std::clamp(velocity, -link.max_velocity, link.max_velocity);
}

void Articulation::HoldStill(int joint) {
  CheckJoint(joint);
  velocity_targets_[joint] = 0;
  position_references_[joint] = bullet_->getJointPos(joint);
}

void Articulation::SetPositions(std::span<const int> joints, std::span<const double> positions) {
  if (positions.size() != joints.size()) {
    throw std::invalid_argument("positions are " + std::to_string(positions.size()) +
                                ", expected one for each of " + std::to_string(joints.size()) +
                                " joints");
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    CheckJoint(joints[i]);
    const LinkSpec& link = spec_->links[joints[i]];
    if (!std::isfinite(positions[i])) {
      throw std::invalid_argument(link.joint_name + ": position is not finite");
    }
    const double q = std::clamp(positions[i], link.lower, link.upper);
    position_references_[joints[i]] = q;
    bullet_->setJointPos(joints[i], q);
    bullet_->setJointVel(joints[i], 0);
  }
  UpdateLinkTransforms();
}

void Articulation::UpdateLinkTransforms() {
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> origins;
  bullet_->forwardKinematics(rotations, origins);
  bullet_->updateCollisionObjectWorldTransforms(rotations, origins);
}

bool Articulation::is_at_rest() const {
  for (int i = 0; i < num_joints(); ++i) {
    if (velocity_targets_[i] != 0 || std::abs(bullet_->getJointVel(i)) > kRest ||
        std::abs(bullet_->getJointPos(i) - position_references_[i]) > kRest) {
      return false;
    }
  }
  return true;
}

void Articulation::DriveMotors(double step_seconds, double gravity) {
  for (int i = 0; i < num_joints(); ++i) {
    const LinkSpec& link = spec_->links[i];
    const double q = bullet_->getJointPos(i);
    const double max_lead =
        link.joint_type == JointType::kRevolute ? config_.max_lead_angle : config_.max_lead_length;
    const double wanted = position_references_[i] + velocity_targets_[i] * step_seconds;
    const double reference =
        std::clamp(std::clamp(wanted, q - max_lead, q + max_lead), link.lower, link.upper);
    // At a limit or when blocked the reference stands still, and so does the commanded speed.
    const double speed = reference == wanted ? velocity_targets_[i]
                                             : (reference - position_references_[i]) / step_seconds;
    position_references_[i] = reference;

    btMultiBodyJointMotor& motor = *links_->links[i].motor;
    motor.setPositionTarget(reference, config_.position_gain);
    motor.setVelocityTarget(speed, 1.0);
    motor.setMaxAppliedImpulse(link.max_effort * config_.effort_scale * step_seconds);
    bullet_->addLinkForce(i, btVector3(0, 0, gravity * link.mass));
  }
}

}  // namespace smile::physics
