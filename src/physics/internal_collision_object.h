#pragma once

#include "base/bytes.h"
#include "physics/internal_bullet.h"

// What bodies and links have in common: kinematic motion, and their part of a snapshot's state.

namespace smile::physics {

/// Makes an object kinematic: it follows its commanded motion and pushes what is in its way, and
/// nothing pushes it. It has no mass of its own until it is given one.
void MakeKinematic(btRigidBody* object);
/// Gives a kinematic object the velocity that brings it to `X_WGoal` in so many seconds; it does
/// not yet move.
void SetVelocityToReach(const RigidTransform& X_WGoal, double seconds, btRigidBody* object);
/// Moves an object to `X_W`; it keeps its velocity.
void SetPose(const RigidTransform& X_W, btCollisionObject* object);

void WriteVector(const btVector3& v, ByteWriter* out);
inline btVector3 ReadVector(ByteReader* in) {
  const double x = in->Get<double>(), y = in->Get<double>(), z = in->Get<double>();
  return {x, y, z};
}
/// Writes poses, sleep state and bounds.
void SaveObject(const btCollisionObject& object, ByteWriter* out);
void RestoreObject(ByteReader* in, btCollisionObject* object);

}  // namespace smile::physics
