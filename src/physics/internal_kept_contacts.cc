#include "physics/internal_kept_contacts.h"

#include <algorithm>
#include <vector>

#include "contacts/support.h"

namespace smile::physics {
namespace {

btScalar SizeOf(const btBroadphaseProxy& proxy) {
  return (proxy.m_aabbMax - proxy.m_aabbMin).length() / 2;
}

/// Returns the contacts of two bodies where the bodies are now.
std::vector<contacts::Contact> PresentContacts(std::span<btPersistentManifold* const> manifolds) {
  std::vector<contacts::Contact> present;
  for (btPersistentManifold* manifold : manifolds) {
    const btTransform& X_WA = manifold->getBody0()->getWorldTransform();
    const btTransform& X_WB = manifold->getBody1()->getWorldTransform();
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold->getContactPoint(k);
      const btVector3 p_WB = X_WB * point.m_localPointB, p_BA_W = X_WA * point.m_localPointA - p_WB;
      present.push_back({.p_WB = FromBullet(p_WB),
                         .p_BA_W = FromBullet(p_BA_W),
                         .normal = FromBullet(point.m_normalWorldOnB),
                         .distance = p_BA_W.dot(point.m_normalWorldOnB)});
    }
  }
  return present;
}

/// Keeps the contacts of two bodies if one stands firmly on the other.
bool Keep(const btBroadphasePair& pair, btCollisionDispatcher& dispatcher) {
  const btCollisionObject *a = ObjectOf(pair.m_pProxy0), *b = ObjectOf(pair.m_pProxy1);
  const bool are_bodies = btRigidBody::upcast(a) != nullptr && btRigidBody::upcast(b) != nullptr;
  // The algorithm comes with the first step of a pair.
  if (!are_bodies || pair.m_algorithm == nullptr || !dispatcher.needsCollision(a, b)) return false;
  btManifoldArray manifolds;
  pair.m_algorithm->getAllContactManifolds(manifolds);
  const double size = std::min(SizeOf(*pair.m_pProxy0), SizeOf(*pair.m_pProxy1));
  if (!contacts::StandsFirmly(PresentContacts(All(manifolds)), size)) return false;
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
