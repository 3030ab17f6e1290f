#pragma once

#include <array>
#include <span>
#include <tuple>
#include <vector>

#include "base/bytes.h"
#include "physics/internal_exact_world.h"
#include "physics/internal_stateless_broadphase.h"

namespace smile::physics {

/// Identifies a contact manifold in any process: the order of both objects, then their pair of
/// parts.
using ManifoldKey = std::tuple<int, int, int>;
ManifoldKey KeyOfManifold(const btPersistentManifold* manifold);

/// Contact points of one pair, with the impulses that the next solve starts from.
struct SavedManifold {
  ManifoldKey key;
  int count = 0;
  std::array<btManifoldPoint, MANIFOLD_CACHE_SIZE> points;
};

/// Contact manifold and the object with which it is saved.
struct OwnedManifold {
  int owner;  ///< order of the object
  btPersistentManifold* manifold;
};

/// Writes contact manifolds, which the caller has sorted by their keys.
void SaveContacts(std::span<const OwnedManifold> touching, ByteWriter* out);

/// Reads what SaveContacts() wrote, to the end of a list. The input is not trusted.
/// @throws std::invalid_argument if the bytes are not contacts.
void ReadContacts(ByteReader* in, std::vector<SavedManifold>* contacts);

/// Restores saved contact points. The world must contain the saved objects in their saved poses;
/// its present contacts are dropped.
/// @throws std::invalid_argument if the points do not fit the world's objects.
void RestoreContacts(ExactWorld& world, StatelessBroadphase& broadphase,
                     std::vector<SavedManifold> saved);

}  // namespace smile::physics
