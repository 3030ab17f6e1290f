#include "physics/internal_compound_pairs.h"

#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

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

/// Rounding of boxes and distances is less than this [m].
constexpr btScalar kReachSlack = 1e-5;

/// Returns the distance up to which two objects, and their parts, have contacts [m].
btScalar ReachOf(const btCollisionShape& a, const btCollisionShape& b) {
  return std::min(a.getContactBreakingThreshold(gContactBreakingThreshold),
                  b.getContactBreakingThreshold(gContactBreakingThreshold));
}

/// Returns true if two boxes are so close that what is in them may have contacts.
bool AreClose(const PosedPart& a, const PosedPart& b, btScalar reach) {
  const btVector3 margin(reach, reach, reach);
  return TestAabbAgainstAabb2(a.min - margin, a.max + margin, b.min, b.max);
}

/// Returns a box around all parts, without a pose.
PosedPart BoxOf(std::span<const PosedPart> parts) {
  PosedPart box = parts.front();
  for (const PosedPart& part : parts) {
    box.min.setMin(part.min);
    box.max.setMax(part.max);
  }
  return box;
}

/// Writes the numbers of the parts that are close to a box, or of all parts, to `close`.
void FindCloseTo(const PosedPart& box, std::span<const PosedPart> parts, btScalar reach,
                 std::vector<int>* close) {
  close->clear();
  for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
    if (AreClose(box, parts[i], reach)) close->push_back(i);
  }
}

/// Objects farther apart than this, beyond the distance at which contact begins, need no exact
/// clearance [m].
constexpr btScalar kMaxClearance = 0.1;

/// Returns a lower bound of the distance of two boxes [m].
btScalar GapBetween(const PosedPart& a, const PosedPart& b) {
  btVector3 gap = a.min - b.max;
  gap.setMax(b.min - a.max);
  gap.setMax(btVector3(0, 0, 0));
  return gap.length();
}

/// Returns the point of a part that lies farthest along `direction`, in the world.
btVector3 Farthest(const btConvexShape& part, const btTransform& X_WP, const btVector3& direction) {
  return X_WP * part.localGetSupportingVertex(direction * X_WP.getBasis());
}

/// Returns a lower bound of the distance of two parts, as near to it as can be found [m]; 0 if they
/// overlap.
btScalar DistanceBetween(const btCollisionShape& a, const btTransform& X_WA,
                         const btCollisionShape& b, const btTransform& X_WB) {
  // MakeCollisionShape() makes convex parts only.
  const auto& part_a = static_cast<const btConvexShape&>(a);
  const auto& part_b = static_cast<const btConvexShape&>(b);
  btVoronoiSimplexSolver simplex;
  btGjkPairDetector detector(&part_a, &part_b, &simplex, /*penetrationDepthSolver=*/nullptr);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = X_WA;
  input.m_transformB = X_WB;
  btPointCollector closest;
  detector.getClosestPoints(input, closest, /*debugDraw=*/nullptr);
  if (!closest.m_hasResult) return 0;
  // The detector rounds the edges of boxes, which collide as if sharp. What lies between the parts
  // along the direction that it found bounds their distance, sharp or not.
  const btVector3& from_b_to_a = closest.m_normalOnBInWorld;
  const btVector3 gap = Farthest(part_a, X_WA, -from_b_to_a) - Farthest(part_b, X_WB, from_b_to_a);
  return std::max(gap.dot(from_b_to_a), btScalar(0));
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
  // The dispatcher owns the memory of algorithms, and has a pool for those of Bullet's size.
  static_assert(sizeof(CompoundPairAlgorithm) <= sizeof(btConvexConvexAlgorithm));
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
  for (const auto& [numbers, pair] : pairs_) Free(pair);
}

void CompoundPairAlgorithm::Free(const PartPair& pair) {
  pair.algorithm->~btCollisionAlgorithm();
  m_dispatcher->freeCollisionAlgorithm(pair.algorithm);
}

/// Finds the pairs of parts that are close, and ends those that neither are nor have contacts.
void CompoundPairAlgorithm::UpdatePairs(const Parts& a, const Parts& b) {
  for (auto& [numbers, pair] : pairs_) pair.are_close = false;
  const bool all = AllPartPairsScope::is_active();
  // Only their memory outlives the call.
  static thread_local std::vector<int> close_a, close_b;
  const btScalar reach =
      all ? BT_LARGE_FLOAT
          : kReachSlack + ReachOf(*a.whole->getCollisionShape(), *b.whole->getCollisionShape());
  FindCloseTo(BoxOf(b.posed), a.posed, reach, &close_a);
  FindCloseTo(BoxOf(a.posed), b.posed, reach, &close_b);
  for (const int i : close_a) {
    for (const int j : close_b) {
      if (!AreClose(a.posed[i], b.posed[j], reach)) continue;
      const auto [entry, is_new] = pairs_.try_emplace({i, j});
      entry->second.are_close = true;
      if (!is_new) continue;
      const btCollisionObjectWrapper part_a = Wrap(a, i), part_b = Wrap(b, j);
      entry->second.algorithm =
          m_dispatcher->findAlgorithm(&part_a, &part_b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    }
  }
  std::erase_if(pairs_, [this](const auto& entry) {
    const PartPair& pair = entry.second;
    if (pair.are_close || pair.manifold->getNumContacts() > 0) return false;
    Free(pair);
    return true;
  });
}

/// Returns true if the objects cannot have come into contact since their clearance was measured.
bool CompoundPairAlgorithm::AreClear(const btTransform& X_AB) const {
  if (clearance_ == nullptr) return false;
  // In A's frame, a point of B has moved by no more than B's origin and what the turn does to the
  // farthest point.
  btScalar turn = 0;
  for (int i = 0; i < 3; ++i)
    turn += (X_AB.getBasis()[i] - clearance_->X_AB.getBasis()[i]).length2();
  const btScalar moved = (X_AB.getOrigin() - clearance_->X_AB.getOrigin()).length() +
                         std::sqrt(turn) * clearance_->radius_b;
  return moved < clearance_->distance;
}

/// Measures the clearance of objects without contact.
void CompoundPairAlgorithm::MeasureClearance(const Parts& a, const Parts& b,
                                             const btTransform& X_AB) {
  for (const auto& [numbers, pair] : pairs_) {
    if (pair.manifold != nullptr && pair.manifold->getNumContacts() > 0) return;
  }
  const btCollisionShape* shape_a = a.whole->getCollisionShape();
  const btCollisionShape* shape_b = b.whole->getCollisionShape();
  const btScalar reach = ReachOf(*shape_a, *shape_b);
  btScalar least = reach + kMaxClearance;
  for (std::size_t i = 0; i < a.posed.size(); ++i) {
    for (std::size_t j = 0; j < b.posed.size(); ++j) {
      if (GapBetween(a.posed[i], b.posed[j]) >= least) continue;
      least = std::min(least, DistanceBetween(*PartShape(shape_a, i), a.posed[i].X_WP,
                                              *PartShape(shape_b, j), b.posed[j].X_WP));
      if (least <= reach) return;
    }
  }
  btVector3 center_b;
  btScalar radius_b;
  shape_b->getBoundingSphere(center_b, radius_b);
  clearance_ =
      std::make_unique<Clearance>(Clearance{least - reach, X_AB, center_b.length() + radius_b});
  // What is no state leaves no trace: parts are paired again when the objects come near.
  for (const auto& [numbers, pair] : pairs_) Free(pair);
  pairs_.clear();
}

void CompoundPairAlgorithm::processCollision(const btCollisionObjectWrapper* a,
                                             const btCollisionObjectWrapper* b,
                                             const btDispatcherInfo& info,
                                             btManifoldResult* result) {
  const btTransform X_AB = a->getWorldTransform().inverseTimes(b->getWorldTransform());
  const bool all = AllPartPairsScope::is_active();
  if (!all && AreClear(X_AB)) return;
  clearance_ = nullptr;
  PosedPart single_a, single_b;
  const Parts parts_a = {a, PartsOf(a, &single_a)}, parts_b = {b, PartsOf(b, &single_b)};
  UpdatePairs(parts_a, parts_b);
  for (auto& [numbers, pair] : pairs_) {
    const btCollisionObjectWrapper part_a = Wrap(parts_a, numbers.first);
    const btCollisionObjectWrapper part_b = Wrap(parts_b, numbers.second);
    const btCollisionObjectWrapper* whole_a = result->getBody0Wrap();
    const btCollisionObjectWrapper* whole_b = result->getBody1Wrap();
    // Bullet's result takes the poses and part numbers of contact points from these.
    result->setBody0Wrap(&part_a);
    result->setBody1Wrap(&part_b);
    result->setShapeIdentifiersA(-1, numbers.first);
    result->setShapeIdentifiersB(-1, numbers.second);
    if (pair.are_close) {
      Collide(pair, part_a, part_b, info, result);
      // Numbers begin at 1: 0 means a pair without parts.
      if (pair.manifold != nullptr) {
        pair.manifold->m_companionIdA = 1 + numbers.first * kMaxParts + numbers.second;
      }
    } else {
      // The parts moved apart: let the points of earlier steps expire.
      result->setPersistentManifold(pair.manifold);
      result->refreshContactPoints();
    }
    result->setBody0Wrap(whole_a);
    result->setBody1Wrap(whole_b);
  }
  // A pair that is asked about once, as by OverlapProbe, needs none.
  if (!all && was_processed_) MeasureClearance(parts_a, parts_b, X_AB);
  was_processed_ = true;
}

void CompoundPairAlgorithm::Collide(PartPair& pair, const btCollisionObjectWrapper& a,
                                    const btCollisionObjectWrapper& b, const btDispatcherInfo& info,
                                    btManifoldResult* result) {
  pair.algorithm->processCollision(&a, &b, info, result);
  if (pair.manifold != nullptr) return;
  // The algorithm has a manifold from its first call on.
  btManifoldArray manifolds;
  pair.algorithm->getAllContactManifolds(manifolds);
  if (manifolds.size() > 0) pair.manifold = manifolds[0];
}

void CompoundPairAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) {
  // Some algorithms have a manifold before their first call, which PartPair does not know.
  for (const auto& [numbers, pair] : pairs_) pair.algorithm->getAllContactManifolds(manifolds);
}

}  // namespace smile::physics
