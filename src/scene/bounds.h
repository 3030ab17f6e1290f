#pragma once

#include <span>

#include "scene/solid.h"

namespace smile::scene {

/// A cuboid along the axes of some frame A, which holds something.
struct Bounds {
  Vector3 low = Vector3::Constant(1), high = Vector3::Constant(-1);  ///< in A [m]; so: empty

  bool is_empty() const { return (low.array() > high.array()).any(); }
  Vector3 center() const { return (low + high) / 2; }
  Vector3 size() const { return high - low; }
  /// Grows until it holds the other, too.
  void Add(const Bounds& other);
  /// True when the two have points in common, or are less than `margin` apart along each axis.
  bool Meets(const Bounds& other, double margin = 0) const;

  bool operator==(const Bounds&) const = default;
};

/// The smallest about a convex piece S.
Bounds BoundsOf(const SolidShape& shape, const RigidTransform& X_AS);
/// The smallest about all pieces of a body B; empty without pieces.
Bounds BoundsOf(std::span<const Solid> solids, const RigidTransform& X_AB);

}  // namespace smile::scene
