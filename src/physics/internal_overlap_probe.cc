#include "physics/internal_overlap_probe.h"

#include <algorithm>

// Measures how deep two shapes overlap, with a dispatcher of its own: the world's dispatcher would
// create manifolds, and a question must leave no trace in the state.

namespace smile::physics {
namespace {

/// Keeps only the depth of the deepest point.
struct DeepestPoint : btManifoldResult {
  using btManifoldResult::btManifoldResult;
  void addContactPoint(const btVector3&, const btVector3&, btScalar distance) override {
    depth = std::max(depth, -distance);
  }
  double depth = 0;
};

bool BoxesOverlap(const btCollisionShape& a, const btTransform& X_WA, const btCollisionShape& b,
                  const btTransform& X_WB) {
  btVector3 min_a, max_a, min_b, max_b;
  a.getAabb(X_WA, min_a, max_a);
  b.getAabb(X_WB, min_b, max_b);
  return TestAabbAgainstAabb2(min_a, max_a, min_b, max_b);
}

/// One question needs few of them; to clear the pools of a world took as long as hundreds of
/// questions.
btDefaultCollisionConstructionInfo SmallPools() {
  btDefaultCollisionConstructionInfo sizes;
  sizes.m_defaultMaxPersistentManifoldPoolSize = 16;
  sizes.m_defaultMaxCollisionAlgorithmPoolSize = 16;
  return sizes;
}

}  // namespace

OverlapProbe::OverlapProbe()
    : collision_configuration_(SmallPools()), dispatcher_(&collision_configuration_) {
  compound_pairs_.RegisterWith(&dispatcher_);
}

double OverlapProbe::Depth(btCollisionShape* a, const btTransform& X_WA, btCollisionShape* b,
                           const btTransform& X_WB) {
  if (!BoxesOverlap(*a, X_WA, *b, X_WB)) return 0;
  btCollisionObject object_a, object_b;
  object_a.setCollisionShape(a);
  object_a.setWorldTransform(X_WA);
  object_b.setCollisionShape(b);
  object_b.setWorldTransform(X_WB);
  const btCollisionObjectWrapper wrapped_a(nullptr, a, &object_a, X_WA, -1, -1);
  const btCollisionObjectWrapper wrapped_b(nullptr, b, &object_b, X_WB, -1, -1);
  DeepestPoint deepest(&wrapped_a, &wrapped_b);
  btCollisionAlgorithm* algorithm =
      dispatcher_.findAlgorithm(&wrapped_a, &wrapped_b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  algorithm->processCollision(&wrapped_a, &wrapped_b, btDispatcherInfo(), &deepest);
  // Allocated from the dispatcher's pool, and therefore not deleted.
  algorithm->~btCollisionAlgorithm();
  dispatcher_.freeCollisionAlgorithm(algorithm);
  return deepest.depth;
}

double OverlapProbe::Depth(const btCollisionObject& a, const btTransform& X_WA,
                           const btCollisionObject& b) {
  const auto shape_of = [](const btCollisionObject& object) {
    return const_cast<btCollisionShape*>(object.getCollisionShape());
  };
  return Depth(shape_of(a), X_WA, shape_of(b), b.getWorldTransform());
}

}  // namespace smile::physics
