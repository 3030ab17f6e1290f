#pragma once

#include <array>
#include <functional>
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
  int owner = 0;  ///< order of the object with which it is saved
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

/// Reads what SaveContacts() wrote for an owner, to the end of a list. The input is not trusted.
/// @throws std::invalid_argument if the bytes are not contacts.
void ReadContacts(int owner, ByteReader* in, std::vector<SavedManifold>* contacts);

/// Tells whose contacts are restored.
struct ContactOwners {
  /// Returns the object of an order, or null if there is none in the world.
  std::function<btCollisionObject*(int order)> object_of;
  /// Returns the order of the object with which contacts of two objects are saved.
  std::function<int(const btCollisionObject* a, const btCollisionObject* b)> owner_of;
  /// Returns true if the saved contacts replace those of this owner; the others stay as they are.
  std::function<bool(int owner)> is_replaced;
};

/// Restores saved contact points, of replaced owners only. Their objects must be in the world, in
/// their saved poses.
/// @throws std::invalid_argument if the points do not fit the world's objects.
void RestoreContacts(std::span<const SavedManifold> saved, const ContactOwners& owners,
                     ExactWorld& world, StatelessBroadphase& broadphase);

}  // namespace smile::physics
