#include "physics/body.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "physics/internal_body_dynamics.h"

namespace smile::physics {

Body::Body(BodyId id, std::shared_ptr<const BodySpec> spec)
    : id_(id), spec_(std::move(spec)), dynamics_(std::make_unique<Dynamics>(id, *spec_)) {
  dynamics_->bullet().setUserPointer(this);
}

Body::~Body() = default;

/// Bullet's transform is that of the center of mass.
RigidTransform Body::pose_in_world() const {
  return FromBullet(dynamics_->bullet().getWorldTransform()) * dynamics_->X_BcmB();
}
Vector3 Body::linear_velocity() const {
  // Bullet's velocity is that of the center of mass; the origin also moves by the rotation.
  return FromBullet(dynamics_->bullet().getLinearVelocity()) +
         angular_velocity().cross(dynamics_->p_BcmB_W());
}
Vector3 Body::angular_velocity() const {
  return FromBullet(dynamics_->bullet().getAngularVelocity());
}
bool Body::is_awake() const { return !is_static() && dynamics_->bullet().isActive(); }
bool Body::is_carried() const { return dynamics_->is_carried(); }

void Body::SetCarried(bool is_carried) {
  if (is_static()) {
    throw std::logic_error("body " + std::to_string(id_.value) + " is static, it can't be carried");
  }
  dynamics_->set_is_carried(is_carried);
  WakeUp();
}

void Body::SetPose(const RigidTransform& X_WB) {
  dynamics_->SetPose(X_WB);
  // the world inertia follows the rotation; the next step uses it
  dynamics_->bullet().updateInertiaTensor();
  // A body that is placed is at rest there; its former velocity has no meaning.
  SetVelocity(Vector3::Zero(), Vector3::Zero());
}

void Body::SetVelocity(const Vector3& linear, const Vector3& angular) {
  WakeUp();
  btRigidBody& bullet = dynamics_->bullet();
  bullet.setLinearVelocity(ToBullet(Vector3(linear - angular.cross(dynamics_->p_BcmB_W()))));
  bullet.setAngularVelocity(ToBullet(angular));
}

void Body::WakeUp() {
  dynamics_->ReturnToWorld();
  if (is_static()) return;
  dynamics_->bullet().forceActivationState(is_carried() ? DISABLE_DEACTIVATION : ACTIVE_TAG);
  // The waiting time before sleep begins again.
  dynamics_->bullet().setDeactivationTime(0);
}

}  // namespace smile::physics
