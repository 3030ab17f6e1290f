#include "physics/internal_body_dynamics.h"

#include "mechanics/rolling_friction.h"
#include "physics/internal_dormant_islands.h"

namespace smile::physics {
namespace {

bool IsStatic(const BodySpec& spec) { return spec.mass.mass == 0; }

/// Returns Bullet's parameters of a body, with its pose given for the center of mass.
btRigidBody::btRigidBodyConstructionInfo ConstructionInfoOf(const BodySpec& spec,
                                                            const RigidTransform& X_BcmB,
                                                            const Vector3& moments,
                                                            btCollisionShape* shape) {
  btRigidBody::btRigidBodyConstructionInfo info(spec.mass.mass, nullptr, shape, ToBullet(moments));
  info.m_startWorldTransform = ToBullet(spec.X_WB * X_BcmB.inverse());
  info.m_friction = spec.friction;
  info.m_restitution = spec.restitution;
  info.m_rollingFriction = mechanics::RollingFrictionOf(spec);
  return info;
}

}  // namespace

Body::Dynamics::Dynamics(BodyId id, const BodySpec& spec)
    : Dynamics(id, spec,
               IsStatic(spec) ? PrincipalInertia() : PrincipalInertiaOf(spec.mass.inertia)) {}

Body::Dynamics::Dynamics(BodyId id, const BodySpec& spec, const PrincipalInertia& inertia)
    : mass_(spec.mass.mass),
      moments_(inertia.moments),
      // A static body has no center of mass: its origin serves as one.
      X_BcmB_(RigidTransform(inertia.axes, IsStatic(spec) ? Vector3::Zero() : spec.mass.center)
                  .inverse()),
      collision_(MakeCollisionShape(spec.solids, X_BcmB_)),
      bullet_(ConstructionInfoOf(spec, X_BcmB_, moments_, collision_.shape())) {
  bullet_.setUserIndex(static_cast<int>(id.value));
  // Friction anchors store the point where a contact first stuck: without them stacks creep.
  bullet_.setCollisionFlags(bullet_.getCollisionFlags() |
                            btCollisionObject::CF_HAS_FRICTION_ANCHOR);
}

Vector3 Body::Dynamics::p_BcmB_W() const {
  return FromBullet(bullet_.getWorldTransform().getBasis()) * X_BcmB_.translation();
}

void Body::Dynamics::Load(double mass, double moment) {
  if (mass == load_mass_ && moment == load_moment_) return;
  // The load is what a carried body bears besides itself, so that a hand's force per mass lifts all
  // of it.
  load_mass_ = mass;
  load_moment_ = moment;
  // A kinematic body has no mass in Bullet; the load takes effect when it becomes dynamic.
  if (!is_kinematic_) UpdateMass();
}

void Body::Dynamics::SetKinematic(bool is_kinematic) {
  if (is_kinematic == is_kinematic_) return;
  is_kinematic_ = is_kinematic;
  if (is_kinematic) {
    MakeKinematic(&bullet_);
    return;
  }
  // Dynamic again: it needs its mass, which MakeKinematic() removed.
  bullet_.setCollisionFlags(bullet_.getCollisionFlags() & ~btCollisionObject::CF_KINEMATIC_OBJECT);
  UpdateMass();
}

void Body::Dynamics::UpdateMass() {
  bullet_.setMassProps(loaded_mass(), ToBullet(Vector3(moments_.array() + load_moment_)));
  bullet_.updateInertiaTensor();
}

void Body::Dynamics::SetVelocityToReach(const RigidTransform& X_WB, double seconds) {
  physics::SetVelocityToReach(X_WB * X_BcmB_.inverse(), seconds, &bullet_);
}

void Body::Dynamics::SetPose(const RigidTransform& X_WB) {
  physics::SetPose(X_WB * X_BcmB_.inverse(), &bullet_);
}

void Body::Dynamics::ReturnToWorld() {
  if (dormant_islands_ == nullptr) return;
  btRigidBody* const self = &bullet_;
  dormant_islands_->Return({&self, 1});
}

const std::shared_ptr<const std::vector<std::byte>>& Body::Dynamics::known_state() const {
  static const std::shared_ptr<const std::vector<std::byte>> none;
  return known_period_ == dormant_islands_->PeriodOf(bullet_) ? known_state_ : none;
}

void Body::Dynamics::KeepState(std::shared_ptr<const std::vector<std::byte>> state) {
  known_period_ = dormant_islands_->PeriodOf(bullet_);
  known_state_ = std::move(state);
}

void Body::Dynamics::Save(ByteWriter* out) const {
  SaveObject(bullet_, out);
  WriteVector(bullet_.getLinearVelocity(), out);
  WriteVector(bullet_.getAngularVelocity(), out);
  out->Put(is_carried_);
}

void Body::Dynamics::Restore(ByteReader* in) {
  RestoreObject(in, &bullet_);
  bullet_.setLinearVelocity(ReadVector(in));
  bullet_.setAngularVelocity(ReadVector(in));
  // Forces are zero between steps; the world inertia follows from the pose.
  bullet_.clearForces();
  bullet_.updateInertiaTensor();
  is_carried_ = in->Get<bool>();
}

}  // namespace smile::physics
