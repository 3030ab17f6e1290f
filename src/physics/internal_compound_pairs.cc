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
const btCollisionShape* PartShape(const btCollisionShape* shape, int part) {
  if (!shape->isCompound()) return shape;
  return static_cast<const btCompoundShape*>(shape)->getChildShape(part);
}

/// Returns where an object's parts are.
/// @param single  storage for the only part of a shape that is not a compound.
std::span<const PosedPart> PartsOf(const btCollisionObjectWrapper* object, PosedPart* single) {
  const btCollisionShape* shape = object->getCollisionShape();
  const btTransform& X_WA = object->getWorldTransform();
  // MakeCollisionShape() makes no other compounds.
  if (shape->isCompound()) return static_cast<const PosedCompound*>(shape)->PartsAt(X_WA);
  single->X_WP = X_WA;
  shape->getAabb(X_WA, single->min, single->max);
  return {single, 1};
}

/// Returns true if the boxes of two parts are so close that their contacts may persist.
bool AreClose(const PosedPart& a, const PosedPart& b) {
  const btVector3 reach(gContactBreakingThreshold, gContactBreakingThreshold,
                        gContactBreakingThreshold);
  return TestAabbAgainstAabb2(a.min - reach, a.max + reach, b.min, b.max);
}

}  // namespace

struct CompoundPairAlgorithm::Parts {
  const btCollisionObjectWrapper* whole;
  std::span<const PosedPart> posed;
};

/// Returns Bullet's description of a part, which borrows the pose.
btCollisionObjectWrapper CompoundPairAlgorithm::Wrap(const Parts& parts, int part) {
  return {parts.whole,
          PartShape(parts.whole->getCollisionShape(), part),
          parts.whole->getCollisionObject(),
          parts.posed[part].X_WP,
          -1,
          part};
}

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

void CompoundPairAlgorithm::MakePartPairs(const Parts& a, const Parts& b) {
  for (int i = 0; i < static_cast<int>(a.posed.size()); ++i) {
    for (int j = 0; j < static_cast<int>(b.posed.size()); ++j) {
      const btCollisionObjectWrapper part_a = Wrap(a, i), part_b = Wrap(b, j);
      pairs_.push_back(
          {i, j,
           m_dispatcher->findAlgorithm(&part_a, &part_b, nullptr, BT_CONTACT_POINT_ALGORITHMS),
           nullptr});
    }
  }
}

void CompoundPairAlgorithm::processCollision(const btCollisionObjectWrapper* a,
                                             const btCollisionObjectWrapper* b,
                                             const btDispatcherInfo& info,
                                             btManifoldResult* result) {
  PosedPart single_a, single_b;
  const Parts parts_a = {a, PartsOf(a, &single_a)}, parts_b = {b, PartsOf(b, &single_b)};
  // Made once for both bodies: their parts never change while they are in the world.
  if (pairs_.empty()) MakePartPairs(parts_a, parts_b);
  for (PartPair& pair : pairs_) {
    const bool are_close = AllPartPairsScope::is_active() ||
                           AreClose(parts_a.posed[pair.part_a], parts_b.posed[pair.part_b]);
    if (!are_close && (pair.manifold == nullptr || pair.manifold->getNumContacts() == 0)) continue;
    const btCollisionObjectWrapper part_a = Wrap(parts_a, pair.part_a);
    const btCollisionObjectWrapper part_b = Wrap(parts_b, pair.part_b);
    const btCollisionObjectWrapper* whole_a = result->getBody0Wrap();
    const btCollisionObjectWrapper* whole_b = result->getBody1Wrap();
    // Bullet's result takes the poses and part numbers of contact points from these.
    result->setBody0Wrap(&part_a);
    result->setBody1Wrap(&part_b);
    result->setShapeIdentifiersA(-1, pair.part_a);
    result->setShapeIdentifiersB(-1, pair.part_b);
    if (are_close) {
      Collide(pair, part_a, part_b, info, result);
    } else {
      // The parts moved apart: let the points of earlier steps expire.
      result->setPersistentManifold(pair.manifold);
      result->refreshContactPoints();
    }
    result->setBody0Wrap(whole_a);
    result->setBody1Wrap(whole_b);
  }
}

void CompoundPairAlgorithm::Collide(PartPair& pair, const btCollisionObjectWrapper& a,
                                    const btCollisionObjectWrapper& b, const btDispatcherInfo& info,
                                    btManifoldResult* result) {
  pair.algorithm->processCollision(&a, &b, info, result);
  if (pair.manifold != nullptr) return;
  btManifoldArray manifolds;
  pair.algorithm->getAllContactManifolds(manifolds);
  for (int i = 0; i < manifolds.size(); ++i) {
    pair.manifold = manifolds[i];
    // The algorithm has a manifold from its first call on. Numbers begin at 1: 0 means a pair
    // without parts.
    pair.manifold->m_companionIdA = 1 + pair.part_a * kMaxParts + pair.part_b;
  }
}

void CompoundPairAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) {
  // Some algorithms have a manifold before their first call, which PartPair does not know.
  for (const PartPair& pair : pairs_) pair.algorithm->getAllContactManifolds(manifolds);
}

}  // namespace smile::physics
