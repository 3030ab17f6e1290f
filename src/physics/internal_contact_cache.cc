#include "physics/internal_contact_cache.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "physics/internal_compound_pairs.h"

// Contact points in snapshots. Impulses of the last step are the solver's starting point in the
// next one, so points must be restored field by field. Layout: number of manifolds u32; each: key
// (three i32), number of points i32, and the fields of each point in the order of ForEachField().
// Each list belongs to a body, or to all links.

namespace smile::physics {
namespace {

/// Applies `field` to each number of a contact point that persists between steps. Saving and
/// restoring walk the same list, so they cannot disagree. Not byte by byte, since Bullet's struct
/// has padding.
template <class Point, class Field>
void ForEachField(Point& point, Field field) {
  for (auto* v : {&point.m_localPointA, &point.m_localPointB, &point.m_positionWorldOnA,
                  &point.m_positionWorldOnB, &point.m_normalWorldOnB, &point.m_lateralFrictionDir1,
                  &point.m_lateralFrictionDir2}) {
    for (int i = 0; i < 3; ++i) field((*v)[i]);
  }
  for (auto* number :
       {&point.m_distance1, &point.m_combinedFriction, &point.m_combinedRollingFriction,
        &point.m_combinedSpinningFriction, &point.m_combinedRestitution, &point.m_appliedImpulse,
        &point.m_prevRHS, &point.m_appliedImpulseLateral1, &point.m_appliedImpulseLateral2,
        &point.m_contactMotion1, &point.m_contactMotion2, &point.m_contactCFM, &point.m_contactERP,
        &point.m_frictionCFM}) {
    field(*number);
  }
  for (auto* number : {&point.m_partId0, &point.m_partId1, &point.m_index0, &point.m_index1,
                       &point.m_contactPointFlags, &point.m_lifeTime}) {
    field(*number);
  }
}

}  // namespace

ManifoldKey KeyOfManifold(const btPersistentManifold* manifold) {
  return {OrderOf(manifold->getBody0()), OrderOf(manifold->getBody1()), PartPairOf(manifold)};
}

void ReadContacts(ByteReader* in, std::vector<SavedManifold>* contacts) {
  const auto num_manifolds = in->Get<std::uint32_t>();
  // Counts are checked before they are used.
  for (std::uint32_t i = 0; i < num_manifolds && in->ok(); ++i) {
    SavedManifold& manifold = contacts->emplace_back();
    std::get<0>(manifold.key) = in->Get<int>();
    std::get<1>(manifold.key) = in->Get<int>();
    std::get<2>(manifold.key) = in->Get<int>();
    manifold.count = in->Get<int>();
    if (manifold.count < 1 || manifold.count > MANIFOLD_CACHE_SIZE) {
      throw std::invalid_argument("snapshot: a contact manifold has " +
                                  std::to_string(manifold.count) + " points, expected 1 to 4");
    }
    for (int k = 0; k < manifold.count; ++k) {
      manifold.points[k] =
          btManifoldPoint(btVector3(0, 0, 0), btVector3(0, 0, 0), btVector3(0, 0, 0), 0);
      // Fields that are not saved have the values of a new point.
      ForEachField(manifold.points[k], [in]<class T>(T& value) { value = in->Get<T>(); });
    }
  }
  if (!in->ok()) throw std::invalid_argument("snapshot: its contacts are truncated");
}

namespace {

/// Removes all pairs, and with them their contacts and algorithms.
void DropAllPairs(ExactWorld& world, StatelessBroadphase& broadphase) {
  auto* cache = broadphase.getOverlappingPairCache();
  auto& pairs = cache->getOverlappingPairArray();
  while (pairs.size() > 0) {
    cache->removeOverlappingPair(pairs[0].m_pProxy0, pairs[0].m_pProxy1, world.getDispatcher());
  }
}

/// Makes the manifolds of the saved pairs by colliding them once.
void MakeManifolds(ExactWorld& world, StatelessBroadphase& broadphase,
                   const std::vector<SavedManifold>& saved) {
  std::map<int, btBroadphaseProxy*> proxies;
  auto& objects = world.getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    proxies[OrderOf(objects[i])] = objects[i]->getBroadphaseHandle();
  }
  auto* cache = broadphase.getOverlappingPairCache();
  for (const SavedManifold& manifold : saved) {
    const auto a = proxies.find(std::get<0>(manifold.key));
    const auto b = proxies.find(std::get<1>(manifold.key));
    if (a == proxies.end() || b == proxies.end()) {
      throw std::invalid_argument("snapshot: a contact belongs to an unknown object");
    }
    cache->addOverlappingPair(a->second, b->second);
  }
  // Bullet does not collide two sleeping objects: keep all awake meanwhile.
  std::vector<int> activation;
  for (int i = 0; i < objects.size(); ++i) {
    activation.push_back(objects[i]->getActivationState());
    objects[i]->forceActivationState(ACTIVE_TAG);
  }
  {
    const CompoundPairAlgorithm::AllPartPairsScope all_part_pairs_scope;
    world.getDispatcher()->dispatchAllCollisionPairs(cache, world.getDispatchInfo(),
                                                     world.getDispatcher());
  }
  for (int i = 0; i < objects.size(); ++i) objects[i]->forceActivationState(activation[i]);
}

}  // namespace

void SaveContacts(std::span<const OwnedManifold> touching, ByteWriter* out) {
  out->Put(static_cast<std::uint32_t>(touching.size()));
  for (const auto& [owner, manifold] : touching) {
    const auto [a, b, parts] = KeyOfManifold(manifold);
    out->Put(a);
    out->Put(b);
    out->Put(parts);
    out->Put(manifold->getNumContacts());
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      ForEachField(manifold->getContactPoint(k), [out](const auto& value) { out->Put(value); });
    }
  }
}

void RestoreContacts(ExactWorld& world, StatelessBroadphase& broadphase,
                     std::vector<SavedManifold> saved) {
  // Pairs arise in this order.
  std::ranges::sort(saved, {}, &SavedManifold::key);
  DropAllPairs(world, broadphase);
  MakeManifolds(world, broadphase, saved);

  std::map<ManifoldKey, btPersistentManifold*> manifolds;
  btDispatcher* dispatcher = world.getDispatcher();
  for (int i = 0; i < dispatcher->getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher->getManifoldByIndexInternal(i);
    manifolds[KeyOfManifold(manifold)] = manifold;
    // Those that the collision made and the snapshot does not have stay empty.
    manifold->clearManifold();
  }
  for (const SavedManifold& from : saved) {
    const auto to = manifolds.find(from.key);
    if (to == manifolds.end()) {
      throw std::invalid_argument("snapshot: a contact fits no pair of shapes in this world");
    }
    // Overwrite the points of the collision above: only the saved ones have the right impulses and
    // ages.
    to->second->setNumContacts(from.count);
    for (int k = 0; k < from.count; ++k) to->second->getContactPoint(k) = from.points[k];
  }
}

}  // namespace smile::physics
