#pragma once

#include <array>

#include "math/rigid_transform.h"
#include "scene/scene_spec.h"

namespace smile::layout {

using Vector2 = Eigen::Vector2d;

/// Rectangle of the table that an object covers, rotated about the vertical.
struct Footprint {
  Vector2 center = Vector2::Zero();     ///< on the table, in the world [m]
  double yaw_deg = 0;                   ///< from the world's x axis to its first side
  Vector2 half_size = Vector2::Zero();  ///< [m]

  /// Returns its corners in order around it [m].
  std::array<Vector2, 4> corners() const;
};

/// Returns the distance of two footprints [m]; 0 if they have a point in common.
double GapBetween(const Footprint& a, const Footprint& b);

/// Returns the smallest footprint along the object's own sides that covers all its pieces at
/// `X_WB`.
Footprint FootprintOf(const scene::ObjectSpec& object, const RigidTransform& X_WB);

}  // namespace smile::layout
