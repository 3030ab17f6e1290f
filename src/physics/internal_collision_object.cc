#include "physics/internal_collision_object.h"

namespace smile::physics {
namespace {

/// Writes a rotation row by row, then the origin; exact, unlike a quaternion.
void WriteTransform(const btTransform& X, ByteWriter* out) {
  for (int row = 0; row < 3; ++row) WriteVector(X.getBasis()[row], out);
  WriteVector(X.getOrigin(), out);
}

btTransform ReadTransform(ByteReader* in) {
  btMatrix3x3 R;
  for (int row = 0; row < 3; ++row) R[row] = ReadVector(in);
  return btTransform(R, ReadVector(in));
}

}  // namespace

void MakeKinematic(btRigidBody* object) {
  // Mass 0 sets Bullet's static flag; replace it by the kinematic one.
  object->setMassProps(0, btVector3(0, 0, 0));
  object->updateInertiaTensor();
  const int flags = object->getCollisionFlags() & ~btCollisionObject::CF_STATIC_OBJECT;
  object->setCollisionFlags(flags | btCollisionObject::CF_KINEMATIC_OBJECT);
}

void SetVelocityToReach(const RigidTransform& X_WGoal, double seconds, btRigidBody* object) {
  const RigidTransform X_WNow = FromBullet(object->getWorldTransform());
  const Vector3 displacement = X_WGoal.translation() - X_WNow.translation();
  // The rotation from now to the goal, as axis and angle in the world.
  const Eigen::AngleAxisd rotation(Matrix3(X_WGoal.rotation() * X_WNow.rotation().transpose()));
  object->setLinearVelocity(ToBullet(Vector3(displacement / seconds)));
  object->setAngularVelocity(ToBullet(Vector3(rotation.axis() * rotation.angle() / seconds)));
}

void SetPose(const RigidTransform& X_W, btCollisionObject* object) {
  object->setWorldTransform(ToBullet(X_W));
  // Bullet's second copy of the pose.
  object->setInterpolationWorldTransform(ToBullet(X_W));
}

void WriteVector(const btVector3& v, ByteWriter* out) {
  out->PutBytes(std::as_bytes(std::span(v.m_floats).first<3>()));
}

void SaveObject(const btCollisionObject& object, ByteWriter* out) {
  // All that Bullet keeps of an object from one step to the next; see docs/decisions/physics.md,
  // exact snapshots.
  WriteTransform(object.getWorldTransform(), out);
  WriteTransform(object.getInterpolationWorldTransform(), out);
  WriteVector(object.getInterpolationLinearVelocity(), out);
  WriteVector(object.getInterpolationAngularVelocity(), out);
  out->Put(object.getActivationState());
  out->Put(static_cast<double>(object.getDeactivationTime()));
  out->Put(static_cast<double>(object.getHitFraction()));
  WriteVector(object.getBroadphaseHandle()->m_aabbMin, out);
  WriteVector(object.getBroadphaseHandle()->m_aabbMax, out);
}

void RestoreObject(ByteReader* in, btCollisionObject* object) {
  object->setWorldTransform(ReadTransform(in));
  object->setInterpolationWorldTransform(ReadTransform(in));
  object->setInterpolationLinearVelocity(ReadVector(in));
  object->setInterpolationAngularVelocity(ReadVector(in));
  object->forceActivationState(in->Get<int>());
  object->setDeactivationTime(in->Get<double>());
  object->setHitFraction(in->Get<double>());
  object->getBroadphaseHandle()->m_aabbMin = ReadVector(in);
  object->getBroadphaseHandle()->m_aabbMax = ReadVector(in);
}

void AddMotion(const btRigidBody& body, StateHash* hash) {
  const auto add_vector = [hash](const btVector3& v) {
    for (int i = 0; i < 3; ++i) hash->Add(static_cast<double>(v[i]));
  };
  // The pose that Bullet integrates, without conversion: equal hashes mean equal bits.
  const btTransform& X_WBcm = body.getWorldTransform();
  for (int row = 0; row < 3; ++row) add_vector(X_WBcm.getBasis()[row]);
  add_vector(X_WBcm.getOrigin());
  add_vector(body.getLinearVelocity());
  add_vector(body.getAngularVelocity());
  hash->Add(static_cast<std::uint64_t>(body.getActivationState()));
  hash->Add(static_cast<double>(body.getDeactivationTime()));
}

}  // namespace smile::physics
