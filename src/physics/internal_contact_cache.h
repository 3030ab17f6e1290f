#pragma once

#include "base/bytes.h"
#include "physics/internal_dormant_islands.h"
#include "physics/internal_exact_world.h"
#include "physics/internal_stateless_broadphase.h"

namespace smile::physics {

/// Writes all contact points, with the impulses that the next solve starts from.
void SaveContacts(const DormantIslands& islands, ByteWriter* out);

/// Restores saved contact points. The world must contain the saved objects in their saved poses;
/// its present contacts are dropped.
/// @throws std::invalid_argument if the points do not fit the world's objects.
void RestoreContacts(ExactWorld& world, StatelessBroadphase& broadphase, ByteReader* in);

}  // namespace smile::physics
