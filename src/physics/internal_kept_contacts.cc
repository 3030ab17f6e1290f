#include "physics/internal_kept_contacts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace smile::physics {
namespace {

/// A point counts as unmoved while the bodies' marks of it are this close along the face and across
/// it [m].
constexpr btScalar kUnmovedAlong = 1e-5;
constexpr btScalar kUnmovedAcross = 1e-4;
/// Points support a body if they span this part of its size: one that tips moves at some of them.
constexpr btScalar kFirmSpan = 0.2;

bool IsUnmoved(const btManifoldPoint& point, const btTransform& X_WA, const btTransform& X_WB) {
  const btVector3 apart = X_WA * point.m_localPointA - X_WB * point.m_localPointB;
  const btScalar across = apart.dot(point.m_normalWorldOnB);
  const btVector3 along = apart - across * point.m_normalWorldOnB;
  return std::abs(across) < kUnmovedAcross && along.length2() < kUnmovedAlong * kUnmovedAlong;
}

/// Returns the height of the highest triangle of points over the line from the first of them to the
/// one farthest from it; 0 for less than three points.
btScalar HeightOfTriangle(std::span<const btVector3> points) {
  if (points.size() < 3) return 0;
  const auto squared_distance = [&points](const btVector3& p) { return p.distance2(points[0]); };
  const btVector3 base = *std::ranges::max_element(points, {}, squared_distance) - points[0];
  btScalar highest = 0;
  for (const btVector3& p : points) highest = std::max(highest, base.cross(p - points[0]).length2());
  return highest > 0 ? std::sqrt(highest / base.length2()) : 0;
}

btScalar SizeOf(const btBroadphaseProxy& proxy) {
  return (proxy.m_aabbMax - proxy.m_aabbMin).length() / 2;
}

/// Returns true if one body stands firmly on the other, at the points that they have.
bool IsFirm(const btBroadphasePair& pair, std::span<btPersistentManifold* const> manifolds) {
  std::vector<btVector3> points;
  for (btPersistentManifold* manifold : manifolds) {
    const btTransform& X_WA = manifold->getBody0()->getWorldTransform();
    const btTransform& X_WB = manifold->getBody1()->getWorldTransform();
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold->getContactPoint(k);
      if (!IsUnmoved(point, X_WA, X_WB)) return false;
      points.push_back(point.m_positionWorldOnB);
    }
  }
  const btScalar size = std::min(SizeOf(*pair.m_pProxy0), SizeOf(*pair.m_pProxy1));
  return HeightOfTriangle(points) > kFirmSpan * size;
}

/// Keeps the contacts of two bodies if one stands firmly on the other.
bool Keep(const btBroadphasePair& pair, btCollisionDispatcher& dispatcher) {
  const btCollisionObject *a = ObjectOf(pair.m_pProxy0), *b = ObjectOf(pair.m_pProxy1);
  const bool are_bodies = btRigidBody::upcast(a) != nullptr && btRigidBody::upcast(b) != nullptr;
  // The algorithm comes with the first step of a pair.
  if (!are_bodies || pair.m_algorithm == nullptr || !dispatcher.needsCollision(a, b)) return false;
  btManifoldArray manifolds;
  pair.m_algorithm->getAllContactManifolds(manifolds);
  if (!IsFirm(pair, All(manifolds))) return false;
  for (btPersistentManifold* manifold : All(manifolds)) {
    manifold->refreshContactPoints(manifold->getBody0()->getWorldTransform(),
                                   manifold->getBody1()->getWorldTransform());
  }
  return true;
}

}  // namespace

void KeepOrCollide(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                   const btDispatcherInfo& info) {
  if (!Keep(pair, dispatcher)) btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}

}  // namespace smile::physics
