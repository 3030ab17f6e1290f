#include "scene/bounds.h"

#include <cmath>

#include "base/overloaded.h"

namespace smile::scene {
namespace {

/// Returns half of the extent, along the axes of A, of a shape that is symmetric about its origin
/// [m].
Vector3 HalfExtent(const Block& block, const Matrix3& R_AS) {
  // Along an axis of A the eight corners reach as far as the sum of the absolute components.
  return R_AS.cwiseAbs() * (block.size / 2);
}

Vector3 HalfExtent(const Sphere& sphere, const Matrix3&) {
  return Vector3::Constant(sphere.radius);
}

Vector3 HalfExtent(const Cylinder& cylinder, const Matrix3& R_AS) {
  const Vector3 axis = R_AS.col(1);
  // The end circles extend along an axis of A by the radius times the sine of the angle between
  // that axis and the cylinder's.
  const Vector3 across = (Vector3::Ones() - axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
  return axis.cwiseAbs() * (cylinder.length / 2) + across * cylinder.radius;
}

}  // namespace

void Bounds::Add(const Bounds& other) {
  if (other.is_empty()) return;
  if (is_empty()) {
    *this = other;
    return;
  }
  low = low.cwiseMin(other.low);
  high = high.cwiseMax(other.high);
}

bool Bounds::Meets(const Bounds& other, double margin) const {
  if (is_empty() || other.is_empty()) return false;
  return (low.array() - margin < other.high.array()).all() &&
         // Strict: boxes that only touch do not meet with a margin of 0.
         (other.low.array() - margin < high.array()).all();
}

Bounds BoundsOf(const SolidShape& shape, const RigidTransform& X_AS) {
  return std::visit(Overloaded{[&](const Hull& hull) {
                                 Bounds bounds;
                                 for (const Vector3& corner : hull.polyhedron().corners) {
                                   const Vector3 p = X_AS * corner;
                                   bounds.Add({.low = p, .high = p});
                                 }
                                 return bounds;
                               },
                               [&](const auto& symmetric) {
                                 const Vector3 half = HalfExtent(symmetric, X_AS.rotation());
                                 return Bounds{.low = X_AS.translation() - half,
                                               .high = X_AS.translation() + half};
                               }},
                    shape);
}

Bounds BoundsOf(std::span<const Solid> solids, const RigidTransform& X_AB) {
  Bounds bounds;
  for (const Solid& solid : solids) bounds.Add(BoundsOf(solid.shape, X_AB * solid.X_BS));
  return bounds;
}

}  // namespace smile::scene
