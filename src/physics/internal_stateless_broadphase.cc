#include "physics/internal_stateless_broadphase.h"

#include <algorithm>

// Finds pairs of objects whose bounding boxes overlap, as a function of the present boxes only.
// Bullet's tree keeps enlarged boxes and its own order, so a restored world would find other pairs.
// For a few hundred objects, sorting along x is fast enough.

namespace smile::physics {
namespace {

/// Returns true if two bounding boxes overlap.
bool Overlap(const btBroadphaseProxy* a, const btBroadphaseProxy* b) {
  return TestAabbAgainstAabb2(a->m_aabbMin, a->m_aabbMax, b->m_aabbMin, b->m_aabbMax);
}

/// Returns true for a link without solids.
bool IsEmpty(const btCollisionObject* object) {
  const btCollisionShape* shape = object->getCollisionShape();
  return shape->isCompound() &&
         static_cast<const btCompoundShape*>(shape)->getNumChildShapes() == 0;
}

}  // namespace

bool PairFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
  const btCollisionObject* object_a = ObjectOf(a);
  const btCollisionObject* object_b = ObjectOf(b);
  if (object_a->isStaticOrKinematicObject() && object_b->isStaticOrKinematicObject()) return false;
  if (IsEmpty(object_a) || IsEmpty(object_b)) return false;
  return !IsExcluded(OrderOf(object_a), OrderOf(object_b));
}

StatelessBroadphase::StatelessBroadphase(bool has_close_bounds)
    : has_close_bounds_(has_close_bounds) {
  pairs_.setOverlapFilterCallback(&filter_);
}

void StatelessBroadphase::UpdateBounds(btCollisionObject& object) {
  /// Diagonal of the box of a body whose motion has no meaning any more, squared [m2].
  constexpr btScalar kAstray = 1e12;
  auto* proxy = static_cast<Proxy*>(object.getBroadphaseHandle());
  const btCollisionShape& shape = *object.getCollisionShape();
  btVector3 min, max;
  shape.getAabb(object.getWorldTransform(), min, max);
  // Links have no predicted pose.
  if (btRigidBody::upcast(&object) != nullptr && !object.isStaticOrKinematicObject()) {
    btVector3 next_min, next_max;
    shape.getAabb(object.getInterpolationWorldTransform(), next_min, next_max);
    min.setMin(next_min);
    max.setMax(next_max);
  }
  // Also true for NaN, which must not come between numbers that are sorted.
  if (!object.isStaticObject() && !((max - min).length2() < kAstray)) {
    object.setActivationState(DISABLE_SIMULATION);
    return;
  }
  const btVector3 reach(proxy->reach, proxy->reach, proxy->reach);
  proxy->m_aabbMin = min - reach;
  proxy->m_aabbMax = max + reach;
}

void StatelessBroadphase::Exclude(const btCollisionObject& a, const btCollisionObject& b,
                                  btDispatcher* dispatcher) {
  filter_.Exclude(OrderOf(&a), OrderOf(&b));
  // The cache takes non-const proxies but does not change these.
  pairs_.removeOverlappingPair(const_cast<btBroadphaseProxy*>(a.getBroadphaseHandle()),
                               const_cast<btBroadphaseProxy*>(b.getBroadphaseHandle()), dispatcher);
}

void StatelessBroadphase::DropPairsOf(const btCollisionObject& object, btDispatcher* dispatcher) {
  pairs_.removeOverlappingPairsContainingProxy(
      const_cast<btBroadphaseProxy*>(object.getBroadphaseHandle()), dispatcher);
}

btBroadphaseProxy* StatelessBroadphase::createProxy(const btVector3& aabb_min,
                                                    const btVector3& aabb_max, int, void* object,
                                                    int group, int mask, btDispatcher*) {
  auto proxy = std::make_unique<Proxy>(aabb_min, aabb_max, object, group, mask);
  // Two objects touch up to the smaller of the distances that Bullet derives from their sizes.
  proxy->reach = gContactBreakingThreshold;
  if (has_close_bounds_) {
    const btCollisionShape& shape = *ObjectOf(proxy.get())->getCollisionShape();
    proxy->reach = std::min(proxy->reach, shape.getContactBreakingThreshold(proxy->reach));
  }
  // Bullet sorts pairs by the unique id, so it must not depend on history.
  proxy->m_uniqueId = OrderOf(ObjectOf(proxy.get()));
  swept_.push_back(proxy.get());
  proxies_.push_back(std::move(proxy));
  return proxies_.back().get();
}

void StatelessBroadphase::destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) {
  pairs_.removeOverlappingPairsContainingProxy(proxy, dispatcher);
  std::erase(swept_, proxy);
  std::erase_if(proxies_, [proxy](const auto& owned) { return owned.get() == proxy; });
}

void StatelessBroadphase::setAabb(btBroadphaseProxy* proxy, const btVector3& aabb_min,
                                  const btVector3& aabb_max, btDispatcher*) {
  proxy->m_aabbMin = aabb_min;
  proxy->m_aabbMax = aabb_max;
}

void StatelessBroadphase::getAabb(btBroadphaseProxy* proxy, btVector3& aabb_min,
                                  btVector3& aabb_max) const {
  aabb_min = proxy->m_aabbMin;
  aabb_max = proxy->m_aabbMax;
}

void StatelessBroadphase::rayTest(const btVector3&, const btVector3&,
                                  btBroadphaseRayCallback& callback, const btVector3&,
                                  const btVector3&) {
  for (const auto& proxy : proxies_) callback.process(proxy.get());
}

void StatelessBroadphase::aabbTest(const btVector3& aabb_min, const btVector3& aabb_max,
                                   btBroadphaseAabbCallback& callback) {
  for (const auto& proxy : proxies_) {
    if (TestAabbAgainstAabb2(aabb_min, aabb_max, proxy->m_aabbMin, proxy->m_aabbMax)) {
      callback.process(proxy.get());
    }
  }
}

void StatelessBroadphase::calculateOverlappingPairs(btDispatcher* dispatcher) {
  struct RemoveSeparated : btOverlapCallback {
    bool processOverlap(btBroadphasePair& pair) override {
      return !Overlap(pair.m_pProxy0, pair.m_pProxy1);
    }
  } remove_separated;
  // First remove pairs that have separated: their contacts end with them.
  pairs_.processAllOverlappingPairs(&remove_separated, dispatcher);

  // Sweep: after sorting by lower x, the partners of a box follow it up to its upper x. Ties are
  // broken by creation order, so the order of new pairs is reproducible.
  std::sort(swept_.begin(), swept_.end(), [](const auto* a, const auto* b) {
    return a->m_aabbMin.x() != b->m_aabbMin.x() ? a->m_aabbMin.x() < b->m_aabbMin.x()
                                                : a->m_uniqueId < b->m_uniqueId;
  });
  for (std::size_t i = 0; i < swept_.size(); ++i) {
    const btScalar end = swept_[i]->m_aabbMax.x();
    for (std::size_t j = i + 1; j < swept_.size() && swept_[j]->m_aabbMin.x() <= end; ++j) {
      // The cache applies the filter and keeps each pair once.
      if (Overlap(swept_[i], swept_[j])) pairs_.addOverlappingPair(swept_[i], swept_[j]);
    }
  }
}

void StatelessBroadphase::getBroadphaseAabb(btVector3& aabb_min, btVector3& aabb_max) const {
  constexpr btScalar kEverywhere = 1e9;
  aabb_min = btVector3(-kEverywhere, -kEverywhere, -kEverywhere);
  aabb_max = -aabb_min;
}

}  // namespace smile::physics
