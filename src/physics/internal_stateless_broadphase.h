#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "mechanics/excluded_pairs.h"
#include "physics/internal_bullet.h"

namespace smile::physics {

/// Filter of pairs that may collide: neither two objects that nothing can push, nor an excluded
/// pair. A pair that was excluded for several reasons collides again when the last of them ends.
class PairFilter : public btOverlapFilterCallback {
 public:
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;

  void Exclude(int order_a, int order_b) { excluded_.Exclude(order_a, order_b); }
  void Include(int order_a, int order_b) { excluded_.Include(order_a, order_b); }
  bool IsExcluded(int a, int b) const { return excluded_.Contains(a, b); }

 private:
  mechanics::ExcludedPairs excluded_;
};

/// Finds overlapping bounding boxes by a sweep along x.
///
/// The set of pairs is a function of the present boxes and the objects' order only. Bullet's own
/// dynamic tree keeps enlarged boxes whose history decides which pairs exist, so that a restored
/// world would differ from the original.
class StatelessBroadphase : public btBroadphaseInterface {
 public:
  /// @param has_close_bounds  see WorldConfig
  explicit StatelessBroadphase(bool has_close_bounds);

  PairFilter& filter() { return filter_; }
  btBroadphasePairArray& pairs() { return pairs_.getOverlappingPairArray(); }
  /// Excludes two objects of this broadphase and drops their contacts.
  void Exclude(const btCollisionObject& a, const btCollisionObject& b, btDispatcher* dispatcher);

  /// Computes the bounding box of an object: everything that it may touch before the next step has
  /// a box that overlaps it.
  static void UpdateBounds(btCollisionObject& object);

  /// Leaves out the proxies for which `is_taken` is true: no new pairs are found for them.
  template <class Predicate>
  void TakeProxies(Predicate is_taken) {
    std::erase_if(swept_, is_taken);
  }
  void PutProxy(btBroadphaseProxy* proxy) { swept_.push_back(proxy); }

  /// Drops all contacts of an object, for a change in what it may collide with; the next step finds
  /// its pairs again.
  void DropPairsOf(const btCollisionObject& object, btDispatcher* dispatcher);

  btBroadphaseProxy* createProxy(const btVector3& aabb_min, const btVector3& aabb_max,
                                 int shape_type, void* object, int group, int mask,
                                 btDispatcher* dispatcher) override;
  void destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) override;
  void setAabb(btBroadphaseProxy* proxy, const btVector3& aabb_min, const btVector3& aabb_max,
               btDispatcher* dispatcher) override;
  void getAabb(btBroadphaseProxy* proxy, btVector3& aabb_min, btVector3& aabb_max) const override;
  void rayTest(const btVector3& from, const btVector3& to, btBroadphaseRayCallback& callback,
               const btVector3& aabb_min, const btVector3& aabb_max) override;
  void aabbTest(const btVector3& aabb_min, const btVector3& aabb_max,
                btBroadphaseAabbCallback& callback) override;
  void calculateOverlappingPairs(btDispatcher* dispatcher) override;
  btOverlappingPairCache* getOverlappingPairCache() override { return &pairs_; }
  const btOverlappingPairCache* getOverlappingPairCache() const override { return &pairs_; }
  void getBroadphaseAabb(btVector3& aabb_min, btVector3& aabb_max) const override;
  void printStats() override {}

 private:
  struct Proxy : btBroadphaseProxy {
    using btBroadphaseProxy::btBroadphaseProxy;
    btScalar reach = 0;  ///< the box exceeds the object by this much on each side [m]
  };

  bool has_close_bounds_;
  PairFilter filter_;
  btHashedOverlappingPairCache pairs_;
  std::vector<std::unique_ptr<Proxy>> proxies_;
  std::vector<btBroadphaseProxy*> swept_;  ///< those for which pairs are found
};

}  // namespace smile::physics
