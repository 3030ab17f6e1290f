#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/overloaded.h"
#include "scene/solid.h"

namespace smile::robot {

/// Returns the depth of `p_SQ` inside a shape S: the distance to the nearest face [m]; negative
/// outside.
inline double DepthInside(const scene::SolidShape& shape, const Vector3& p_SQ) {
  return std::visit(
      Overloaded{[&](const scene::Block& block) {
                   return (0.5 * block.size - p_SQ.cwiseAbs()).minCoeff();
                 },
                 [&](const scene::Cylinder& cylinder) {
                   return std::min(cylinder.radius - std::hypot(p_SQ.x(), p_SQ.z()),
                                   cylinder.length / 2 - std::abs(p_SQ.y()));
                 },
                 [&](const scene::Sphere& sphere) { return sphere.radius - p_SQ.norm(); },
                 [&](const scene::Hull& hull) {
                   const scene::Polyhedron& polyhedron = hull.polyhedron();
                   double depth = std::numeric_limits<double>::infinity();
                   for (const auto& face : polyhedron.faces) {
                     const Vector3 p_QFace = polyhedron.corners[face[0]] - p_SQ;
                     const Vector3 normal = polyhedron.AreaVectorOf(face).normalized();
                     depth = std::min(depth, normal.dot(p_QFace));
                   }
                   return depth;
                 }},
      shape);
}

/// Returns half the diagonal of a box around the shape [m].
inline double BoundingRadius(const scene::SolidShape& shape) {
  return std::visit(Overloaded{[](const scene::Block& block) { return block.size.norm() / 2; },
                               [](const scene::Cylinder& cylinder) {
                                 return std::hypot(cylinder.radius, cylinder.length / 2);
                               },
                               [](const scene::Sphere& sphere) { return sphere.radius; },
                               [](const scene::Hull& hull) {
                                 double radius = 0;
                                 for (const Vector3& corner : hull.polyhedron().corners) {
                                   radius = std::max(radius, corner.norm());
                                 }
                                 return radius;
                               }},
                    shape);
}

/// Returns points spread over a shape's surface and its middle, at most about 3 cm apart on arm
/// links.
inline std::vector<Vector3> SamplePoints(const scene::SolidShape& shape) {
  constexpr int kSteps = 8;
  constexpr int kTurns = 16;
  std::vector<Vector3> points{Vector3::Zero()};
  const auto add_ring = [&](double radius, double y) {
    for (int i = 0; i < kTurns; ++i) {
      const double angle = 2 * std::numbers::pi * i / kTurns;
      points.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
    }
  };
  std::visit(
      Overloaded{[&](const scene::Block& block) {
                   for (int i = 0; i <= kSteps; ++i) {
                     for (int j = 0; j <= kSteps; ++j) {
                       for (int k = 0; k <= kSteps; ++k) {
                         const Vector3 share(i, j, k);
                         points.push_back(
                             block.size.cwiseProduct(share / kSteps - Vector3::Constant(0.5)));
                       }
                     }
                   }
                 },
                 [&](const scene::Cylinder& cylinder) {
                   for (int i = 0; i <= kSteps; ++i) {
                     const double y = cylinder.length * (double(i) / kSteps - 0.5);
                     add_ring(cylinder.radius, y);
                     add_ring(cylinder.radius / 2, y);
                   }
                 },
                 [&](const scene::Sphere& sphere) {
                   for (int i = 0; i <= kSteps; ++i) {
                     const double angle = std::numbers::pi * i / kSteps;
                     add_ring(sphere.radius * std::sin(angle), sphere.radius * std::cos(angle));
                   }
                 },
                 [&](const scene::Hull& hull) {
                   const auto& corners = hull.polyhedron().corners;
                   points.insert(points.end(), corners.begin(), corners.end());
                 }},
      shape);
  return points;
}

/// Returns true if a sample point of one solid is deeper than `depth` [m] inside the other. It may
/// miss overlaps of a centimeter or two at sharp edges, but has no false positives.
inline bool Overlap(const scene::Solid& a, const RigidTransform& X_WA, const scene::Solid& b,
                    const RigidTransform& X_WB, double depth) {
  const RigidTransform X_AB = X_WA.inverse() * X_WB;
  if (X_AB.translation().norm() > BoundingRadius(a.shape) + BoundingRadius(b.shape)) return false;
  const auto reaches_into = [&](const scene::Solid& from, const scene::Solid& into,
                                const RigidTransform& X_IntoFrom) {
    return std::ranges::any_of(SamplePoints(from.shape), [&](const Vector3& point) {
      return DepthInside(into.shape, X_IntoFrom * point) > depth;
    });
  };
  return reaches_into(b, a, X_AB) || reaches_into(a, b, X_AB.inverse());
}

}  // namespace smile::robot
