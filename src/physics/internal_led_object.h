#pragma once

#include "physics/internal_bullet.h"

namespace smile::physics {

// A led object goes where it is led: it pushes what is in its way, and nothing pushes it.

/// Nothing pushes this object any more. It has no mass of its own until it is given one.
void MakeLed(btRigidBody* object);

/// Gives a led object the velocity that brings it to `X_WTo` in so many seconds; it does not yet
/// move.
void Lead(const RigidTransform& X_WTo, double seconds, btRigidBody* object);

/// Puts a led object there; it keeps its velocity.
void Place(const RigidTransform& X_W, btCollisionObject* object);

}  // namespace smile::physics
