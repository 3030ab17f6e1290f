#pragma once

#include <span>

#include "scene/solid.h"

namespace smile::scene {

/// Axis-aligned bounding box in some frame A.
struct Bounds {
  Vector3 low = Vector3::Constant(1), high = Vector3::Constant(-1);  ///< in A [m]; default: empty

  bool is_empty() const { return (low.array() > high.array()).any(); }
  Vector3 center() const { return (low + high) / 2; }
  Vector3 size() const { return high - low; }
  /// Extends the box to contain the other one.
  void Add(const Bounds& other);
  /// True if the two have points in common, or are less than `margin` apart along each axis.
  bool Meets(const Bounds& other, double margin = 0) const;

  bool operator==(const Bounds&) const = default;
};

/// Returns the smallest box around a convex piece S.
Bounds BoundsOf(const SolidShape& shape, const RigidTransform& X_AS);
/// Returns the box around all pieces of a body B; empty without pieces.
Bounds BoundsOf(std::span<const Solid> solids, const RigidTransform& X_AB);

}  // namespace smile::scene
