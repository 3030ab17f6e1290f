#include "physics/internal_compound_pairs.h"

#include <new>

// Contacts of bodies made of parts. Unlike with Bullet's own algorithm, each pair of parts has one
// manifold, with the numbers of both parts, so that it can be found again in a snapshot
// (docs/decisions/physics.md, exact snapshots).

namespace smile::physics {
namespace {

/// Base of the pair number, which is unique while the second object has fewer parts.
constexpr int kMaxParts = 4096;

/// A shape that is not a compound counts as its own single part.
int NumParts(const btCollisionShape* shape) {
  return shape->isCompound() ? static_cast<const btCompoundShape*>(shape)->getNumChildShapes() : 1;
}

const btCollisionShape* PartShape(const btCollisionShape* shape, int part) {
  if (!shape->isCompound()) return shape;
  return static_cast<const btCompoundShape*>(shape)->getChildShape(part);
}

/// Returns the pose of a part in the world.
btTransform PartPose(const btCollisionObjectWrapper* object, int part) {
  const btCollisionShape* shape = object->getCollisionShape();
  if (!shape->isCompound()) return object->getWorldTransform();
  return object->getWorldTransform() *
         static_cast<const btCompoundShape*>(shape)->getChildTransform(part);
}

/// One part of an object, posed; Bullet's wrapper borrows the pose.
struct Part {
  Part(const btCollisionObjectWrapper* object, int number)
      : X_WP(PartPose(object, number)),
        wrapper(object, PartShape(object->getCollisionShape(), number),
                object->getCollisionObject(), X_WP, -1, number) {}
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  bool BoxOverlaps(const Part& other) const {
    btVector3 min, max, other_min, other_max;
    wrapper.getCollisionShape()->getAabb(X_WP, min, max);
    other.wrapper.getCollisionShape()->getAabb(other.X_WP, other_min, other_max);
    // Contacts persist up to this distance, so parts are processed while their boxes are this
    // close.
    const btVector3 reach(gContactBreakingThreshold, gContactBreakingThreshold,
                          gContactBreakingThreshold);
    return TestAabbAgainstAabb2(min - reach, max + reach, other_min, other_max);
  }

  btTransform X_WP;
  btCollisionObjectWrapper wrapper;
};

}  // namespace

thread_local bool CompoundPairAlgorithm::AllPartPairsScope::is_active_ = false;

btCollisionAlgorithm* CompoundPairAlgorithm::CreateFunc::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper*,
    const btCollisionObjectWrapper*) {
  // The dispatcher owns the memory of algorithms: it frees them by its own pool.
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(CompoundPairAlgorithm));
  return new (memory) CompoundPairAlgorithm(info);
}

void CompoundPairAlgorithm::CreateFunc::RegisterWith(btCollisionDispatcher* dispatcher) {
  // For a compound against anything, on either side.
  for (int type = 0; type < MAX_BROADPHASE_COLLISION_TYPES; ++type) {
    dispatcher->registerCollisionCreateFunc(COMPOUND_SHAPE_PROXYTYPE, type, this);
    dispatcher->registerCollisionCreateFunc(type, COMPOUND_SHAPE_PROXYTYPE, this);
  }
}

CompoundPairAlgorithm::~CompoundPairAlgorithm() {
  for (const PartPair& pair : pairs_) {
    pair.algorithm->~btCollisionAlgorithm();
    m_dispatcher->freeCollisionAlgorithm(pair.algorithm);
  }
}

void CompoundPairAlgorithm::MakePartPairs(const btCollisionObjectWrapper* a,
                                          const btCollisionObjectWrapper* b) {
  for (int i = 0; i < NumParts(a->getCollisionShape()); ++i) {
    for (int j = 0; j < NumParts(b->getCollisionShape()); ++j) {
      const Part part_a(a, i), part_b(b, j);
      pairs_.push_back({i, j,
                        m_dispatcher->findAlgorithm(&part_a.wrapper, &part_b.wrapper, nullptr,
                                                    BT_CONTACT_POINT_ALGORITHMS),
                        nullptr});
    }
  }
}

void CompoundPairAlgorithm::processCollision(const btCollisionObjectWrapper* a,
                                             const btCollisionObjectWrapper* b,
                                             const btDispatcherInfo& info,
                                             btManifoldResult* result) {
  // Made once for both bodies: their parts never change while they are in the world.
  if (pairs_.empty()) MakePartPairs(a, b);
  for (PartPair& pair : pairs_) Collide(pair, a, b, info, result);
}

void CompoundPairAlgorithm::Collide(PartPair& pair, const btCollisionObjectWrapper* a,
                                    const btCollisionObjectWrapper* b, const btDispatcherInfo& info,
                                    btManifoldResult* result) {
  const Part part_a(a, pair.part_a), part_b(b, pair.part_b);
  const btCollisionObjectWrapper* whole_a = result->getBody0Wrap();
  const btCollisionObjectWrapper* whole_b = result->getBody1Wrap();
  // Bullet's result takes the poses and part numbers of contact points from these.
  result->setBody0Wrap(&part_a.wrapper);
  result->setBody1Wrap(&part_b.wrapper);
  result->setShapeIdentifiersA(-1, pair.part_a);
  result->setShapeIdentifiersB(-1, pair.part_b);
  if (AllPartPairsScope::is_active() || part_a.BoxOverlaps(part_b)) {
    pair.algorithm->processCollision(&part_a.wrapper, &part_b.wrapper, info, result);
    if (pair.manifold == nullptr) {
      btManifoldArray manifolds;
      pair.algorithm->getAllContactManifolds(manifolds);
      for (int i = 0; i < manifolds.size(); ++i) {
        pair.manifold = manifolds[i];
        // The algorithm has a manifold from its first call on. Numbers begin at 1: 0 means a pair
        // without parts.
        pair.manifold->m_companionIdA = 1 + pair.part_a * kMaxParts + pair.part_b;
      }
    }
  } else if (pair.manifold != nullptr && pair.manifold->getNumContacts() > 0) {
    // The parts moved apart: let the points of earlier steps expire.
    result->setPersistentManifold(pair.manifold);
    result->refreshContactPoints();
  }
  result->setBody0Wrap(whole_a);
  result->setBody1Wrap(whole_b);
}

void CompoundPairAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) {
  for (const PartPair& pair : pairs_) {
    if (pair.manifold != nullptr) manifolds.push_back(pair.manifold);
  }
}

}  // namespace smile::physics
