#include "physics/body.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "math/principal_inertia.h"
#include "physics/internal_body_shapes.h"
#include "physics/internal_led_object.h"

namespace smile::physics {
namespace {

/// Of balls, rollers and rings [m].
constexpr double kRollingResistance = 0.001;

/// Hulls count as round: a ring's segments are, and the resistance does no harm to the others.
bool IsRound(const BodySpec& spec) {
  for (const scene::Solid& solid : spec.solids) {
    if (!std::holds_alternative<scene::Block>(solid.shape)) return true;
  }
  return false;
}

}  // namespace

Body::Body(BodyId id, std::shared_ptr<const BodySpec> spec)
    : id_(id), spec_(std::move(spec)), shapes_(std::make_unique<Shapes>()) {
  PrincipalInertia inertia;
  if (!is_static()) inertia = PrincipalInertiaOf(spec_->mass.inertia);
  moments_ = inertia.moments;
  X_BcmB_ =
      RigidTransform(inertia.axes, is_static() ? Vector3::Zero() : spec_->mass.center).inverse();
  shapes_->collision = MakeCollisionShape(spec_->solids, X_BcmB_);

  btRigidBody::btRigidBodyConstructionInfo info(
      spec_->mass.mass, nullptr, shapes_->collision.shape(), ToBullet(inertia.moments));
  info.m_startWorldTransform = ToBullet(spec_->X_WB * X_BcmB_.inverse());
  info.m_friction = spec_->friction;
  info.m_restitution = spec_->restitution;
  info.m_rollingFriction =
      spec_->rolling_friction.value_or(IsRound(*spec_) ? kRollingResistance : 0.0);
  bullet_ = std::make_unique<btRigidBody>(info);
  bullet_->setUserIndex(static_cast<int>(id_.value));
  // Friction anchors remember where a contact first stuck: without them stacks creep.
  bullet_->setCollisionFlags(bullet_->getCollisionFlags() |
                             btCollisionObject::CF_HAS_FRICTION_ANCHOR);
}

Body::~Body() = default;

RigidTransform Body::pose_in_world() const {
  return FromBullet(bullet_->getWorldTransform()) * X_BcmB_;
}
Vector3 Body::p_BcmB_W() const {
  return FromBullet(bullet_->getWorldTransform().getBasis()) * X_BcmB_.translation();
}
Vector3 Body::linear_velocity() const {
  return FromBullet(bullet_->getLinearVelocity()) + angular_velocity().cross(p_BcmB_W());
}
Vector3 Body::angular_velocity() const { return FromBullet(bullet_->getAngularVelocity()); }
bool Body::is_awake() const { return !is_static() && bullet_->isActive(); }

void Body::SetCarried(bool is_carried) {
  if (is_static()) {
    throw std::logic_error("body " + std::to_string(id_.value) + " is static, it can't be carried");
  }
  is_carried_ = is_carried;
  WakeUp();
}

void Body::Load(double mass, double moment) {
  if (mass == load_mass_ && moment == load_moment_) return;
  load_mass_ = mass;
  load_moment_ = moment;
  if (is_led_) return;
  bullet_->setMassProps(loaded_mass(), ToBullet(Vector3(moments_.array() + moment)));
  bullet_->updateInertiaTensor();
}

void Body::SetLed(bool is_led) {
  if (is_led == is_led_) return;
  is_led_ = is_led;
  if (is_led) {
    MakeLed(bullet_.get());
    return;
  }
  bullet_->setCollisionFlags(bullet_->getCollisionFlags() &
                             ~btCollisionObject::CF_KINEMATIC_OBJECT);
  bullet_->setMassProps(loaded_mass(), ToBullet(Vector3(moments_.array() + load_moment_)));
  bullet_->updateInertiaTensor();
}

void Body::LeadTo(const RigidTransform& X_WB, double seconds) {
  Lead(X_WB * X_BcmB_.inverse(), seconds, bullet_.get());
}

void Body::PlaceAt(const RigidTransform& X_WB) { Place(X_WB * X_BcmB_.inverse(), bullet_.get()); }

void Body::SetPose(const RigidTransform& X_WB) {
  const btTransform X_WBcm = ToBullet(X_WB * X_BcmB_.inverse());
  bullet_->setWorldTransform(X_WBcm);
  bullet_->setInterpolationWorldTransform(X_WBcm);
  bullet_->updateInertiaTensor();  // it turns with the body: the next step begins with it
  SetVelocity(Vector3::Zero(), Vector3::Zero());
}

void Body::SetVelocity(const Vector3& linear, const Vector3& angular) {
  WakeUp();
  bullet_->setLinearVelocity(ToBullet(Vector3(linear - angular.cross(p_BcmB_W()))));
  bullet_->setAngularVelocity(ToBullet(angular));
}

void Body::WakeUp() {
  if (is_static()) return;
  bullet_->forceActivationState(is_carried_ ? DISABLE_DEACTIVATION : ACTIVE_TAG);
  bullet_->setDeactivationTime(0);
}

}  // namespace smile::physics
