#include "physics/internal_led_object.h"

namespace smile::physics {

void MakeLed(btRigidBody* object) {
  object->setMassProps(0, btVector3(0, 0, 0));
  object->updateInertiaTensor();
  const int flags = object->getCollisionFlags() & ~btCollisionObject::CF_STATIC_OBJECT;
  object->setCollisionFlags(flags | btCollisionObject::CF_KINEMATIC_OBJECT);
}

void Lead(const RigidTransform& X_WTo, double seconds, btRigidBody* object) {
  const RigidTransform X_WNow = FromBullet(object->getWorldTransform());
  const Vector3 way = X_WTo.translation() - X_WNow.translation();
  const Eigen::AngleAxisd turn(Matrix3(X_WTo.rotation() * X_WNow.rotation().transpose()));
  object->setLinearVelocity(ToBullet(Vector3(way / seconds)));
  object->setAngularVelocity(ToBullet(Vector3(turn.axis() * turn.angle() / seconds)));
}

void Place(const RigidTransform& X_W, btCollisionObject* object) {
  object->setWorldTransform(ToBullet(X_W));
  object->setInterpolationWorldTransform(ToBullet(X_W));
}

}  // namespace smile::physics
