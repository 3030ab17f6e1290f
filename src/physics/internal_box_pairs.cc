#include "physics/internal_box_pairs.h"

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>

#include <cmath>
#include <new>

namespace smile::physics {
namespace {

/// A point counts as unmoved while the bodies' marks of it are this close along the face and across
/// it [m].
constexpr btScalar kUnmovedAlong = 1e-5;
constexpr btScalar kUnmovedAcross = 1e-4;
/// Points that support a box on a face.
constexpr int kFacePoints = 3;

bool IsUnmoved(const btManifoldPoint& point, const btTransform& X_WA, const btTransform& X_WB) {
  const btVector3 apart = X_WA * point.m_localPointA - X_WB * point.m_localPointB;
  const btScalar across = apart.dot(point.m_normalWorldOnB);
  const btVector3 along = apart - across * point.m_normalWorldOnB;
  return std::abs(across) < kUnmovedAcross && along.length2() < kUnmovedAlong * kUnmovedAlong;
}

/// Returns true if the bodies rest on a face at the points that they have.
bool RestsOnFace(const btPersistentManifold& manifold, const btTransform& X_WA,
                 const btTransform& X_WB) {
  if (manifold.getNumContacts() < kFacePoints) return false;
  for (int k = 0; k < manifold.getNumContacts(); ++k) {
    if (!IsUnmoved(manifold.getContactPoint(k), X_WA, X_WB)) return false;
  }
  return true;
}

}  // namespace

btCollisionAlgorithm* BoxPairAlgorithm::CreateFunc::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
    const btCollisionObjectWrapper* b) {
  // The dispatcher owns the memory of algorithms: it frees them by its own pool.
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(BoxPairAlgorithm));
  return new (memory) BoxPairAlgorithm(info, a, b);
}

BoxPairAlgorithm::BoxPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                   const btCollisionObjectWrapper* a,
                                   const btCollisionObjectWrapper* b)
    : btCollisionAlgorithm(info),
      manifold_(m_dispatcher->getNewManifold(a->getCollisionObject(), b->getCollisionObject())) {}

BoxPairAlgorithm::~BoxPairAlgorithm() { m_dispatcher->releaseManifold(manifold_); }

void BoxPairAlgorithm::processCollision(const btCollisionObjectWrapper* a,
                                        const btCollisionObjectWrapper* b,
                                        const btDispatcherInfo& info, btManifoldResult* result) {
  result->setPersistentManifold(manifold_);
  // A manifold may name the bodies in the other order than this call.
  const bool is_swapped = manifold_->getBody0() != a->getCollisionObject();
  const btTransform &X_W0 = (is_swapped ? b : a)->getCollisionObject()->getWorldTransform(),
                    &X_W1 = (is_swapped ? a : b)->getCollisionObject()->getWorldTransform();
  if (!RestsOnFace(*manifold_, X_W0, X_W1)) {
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    input.m_maximumDistanceSquared = BT_LARGE_FLOAT;
    input.m_transformA = a->getWorldTransform();
    input.m_transformB = b->getWorldTransform();
    btBoxBoxDetector detector(static_cast<const btBoxShape*>(a->getCollisionShape()),
                              static_cast<const btBoxShape*>(b->getCollisionShape()));
    detector.getClosestPoints(input, *result, info.m_debugDraw);
  }
  result->refreshContactPoints();
}

}  // namespace smile::physics
