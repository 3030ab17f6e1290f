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

/// Computes the poses and boxes of an object's parts.
void PoseParts(const btCollisionObjectWrapper* object, std::vector<PosedPart>* parts) {
  parts->resize(NumParts(object->getCollisionShape()));
  for (int i = 0; i < static_cast<int>(parts->size()); ++i) {
    PosedPart& part = (*parts)[i];
    part.X_WP = PartPose(object, i);
    PartShape(object->getCollisionShape(), i)->getAabb(part.X_WP, part.min, part.max);
  }
}

/// Returns true if the boxes of two parts are so close that their contacts may persist.
bool AreClose(const PosedPart& a, const PosedPart& b) {
  const btVector3 reach(gContactBreakingThreshold, gContactBreakingThreshold,
                        gContactBreakingThreshold);
  return TestAabbAgainstAabb2(a.min - reach, a.max + reach, b.min, b.max);
}

/// Returns Bullet's description of a part, which borrows the pose.
btCollisionObjectWrapper Wrap(const btCollisionObjectWrapper* object, int part,
                              const btTransform& X_WP) {
  return {
      object, PartShape(object->getCollisionShape(), part), object->getCollisionObject(), X_WP, -1,
      part};
}

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
      const btCollisionObjectWrapper part_a = Wrap(a, i, parts_a_[i].X_WP);
      const btCollisionObjectWrapper part_b = Wrap(b, j, parts_b_[j].X_WP);
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
  // Once for each part, which is in many pairs.
  PoseParts(a, &parts_a_);
  PoseParts(b, &parts_b_);
  // Made once for both bodies: their parts never change while they are in the world.
  if (pairs_.empty()) MakePartPairs(a, b);
  for (PartPair& pair : pairs_) Collide(pair, a, b, info, result);
}

void CompoundPairAlgorithm::Collide(PartPair& pair, const btCollisionObjectWrapper* a,
                                    const btCollisionObjectWrapper* b, const btDispatcherInfo& info,
                                    btManifoldResult* result) {
  const PosedPart &posed_a = parts_a_[pair.part_a], &posed_b = parts_b_[pair.part_b];
  const bool are_close = AllPartPairsScope::is_active() || AreClose(posed_a, posed_b);
  if (!are_close && (pair.manifold == nullptr || pair.manifold->getNumContacts() == 0)) return;
  const btCollisionObjectWrapper part_a = Wrap(a, pair.part_a, posed_a.X_WP);
  const btCollisionObjectWrapper part_b = Wrap(b, pair.part_b, posed_b.X_WP);
  const btCollisionObjectWrapper* whole_a = result->getBody0Wrap();
  const btCollisionObjectWrapper* whole_b = result->getBody1Wrap();
  // Bullet's result takes the poses and part numbers of contact points from these.
  result->setBody0Wrap(&part_a);
  result->setBody1Wrap(&part_b);
  result->setShapeIdentifiersA(-1, pair.part_a);
  result->setShapeIdentifiersB(-1, pair.part_b);
  if (are_close) {
    pair.algorithm->processCollision(&part_a, &part_b, info, result);
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
  } else {
    // The parts moved apart: let the points of earlier steps expire.
    result->setPersistentManifold(pair.manifold);
    result->refreshContactPoints();
  }
  result->setBody0Wrap(whole_a);
  result->setBody1Wrap(whole_b);
}

void CompoundPairAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) {
  // Some algorithms have a manifold before their first call, which PartPair does not know.
  for (const PartPair& pair : pairs_) pair.algorithm->getAllContactManifolds(manifolds);
}

}  // namespace smile::physics
