#pragma once

#include "base/bytes.h"
#include "physics/internal_exact_world.h"
#include "physics/internal_stateless_broadphase.h"

namespace smile::physics {

/// Writes all contact points, with the impulses the next solve starts from.
void SaveContacts(ExactWorld& world, ByteWriter* out);

/// Puts saved contact points back. The world must hold the saved objects, already in their saved
/// poses; whatever contacts it had are dropped.
/// @throws std::invalid_argument if the points do not fit the world's objects.
void RestoreContacts(ExactWorld& world, StatelessBroadphase& broadphase, ByteReader* in);

}  // namespace smile::physics
