#pragma once

// Conversions between Bullet's types and those of this project. Only src/physics/*.cc and internal
// headers include this.

#include <btBulletDynamicsCommon.h>

#include <span>

#include "math/rigid_transform.h"

static_assert(sizeof(btScalar) == sizeof(double), "Bullet must be the double-precision build");

namespace smile::physics {

class Body;

inline btVector3 ToBullet(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
inline Vector3 FromBullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

inline btMatrix3x3 ToBullet(const Matrix3& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}
inline Matrix3 FromBullet(const btMatrix3x3& m) {
  Matrix3 result;
  result << m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2];
  return result;
}

inline btTransform ToBullet(const RigidTransform& X) {
  return btTransform(ToBullet(X.rotation()), ToBullet(X.translation()));
}
inline RigidTransform FromBullet(const btTransform& X) {
  return {FromBullet(X.getBasis()), FromBullet(X.getOrigin())};
}

inline btCollisionObject* ObjectOf(const btBroadphaseProxy* proxy) {
  return static_cast<btCollisionObject*>(proxy->m_clientObject);
}

/// Returns the elements of Bullet's array.
template <class Array>
auto All(Array& array) {
  return std::span(array.size() > 0 ? &array[0] : nullptr, static_cast<std::size_t>(array.size()));
}

/// Returns an object's place in the order of creation, which is stored as its user index. Pairs,
/// islands, contacts and world arrays are all sorted by it.
inline int OrderOf(const btCollisionObject* object) { return object->getUserIndex(); }

/// Returns the body of a Bullet object; null for a link.
inline Body* BodyOf(const btCollisionObject* object) {
  return static_cast<Body*>(object->getUserPointer());
}

}  // namespace smile::physics
