#pragma once

#include "base/bytes.h"
#include "base/state_hash.h"
#include "physics/internal_bullet.h"

// Common parts of bodies and links: kinematic motion, and their part of a snapshot's state.

namespace smile::physics {

/// Makes an object kinematic: it follows its commanded motion, pushes other objects and is not
/// pushed. It has no mass until one is set.
void MakeKinematic(btRigidBody* object);
/// Gives a kinematic object the velocity that brings it to `X_WGoal` in `seconds`; does not move
/// it.
void SetVelocityToReach(const RigidTransform& X_WGoal, double seconds, btRigidBody* object);
/// Moves an object to `X_W`; it keeps its velocity.
void SetPose(const RigidTransform& X_W, btCollisionObject* object);

void WriteVector(const btVector3& v, ByteWriter* out);
inline btVector3 ReadVector(ByteReader* in) {
  const double x = in->Get<double>(), y = in->Get<double>(), z = in->Get<double>();
  return {x, y, z};
}
/// Writes poses, sleep state and bounds of an object.
void SaveObject(const btCollisionObject& object, ByteWriter* out);
/// Reads what SaveObject() wrote.
void RestoreObject(ByteReader* in, btCollisionObject* object);

/// Adds a body's pose, velocities and state of sleep.
void AddMotion(const btRigidBody& body, StateHash* hash);

}  // namespace smile::physics
