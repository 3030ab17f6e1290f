#pragma once

#include <array>

#include "math/rigid_transform.h"
#include "scene/scene_spec.h"

namespace smile::layout {

using Vector2 = Eigen::Vector2d;

/// The rectangle of the table that a thing stands on or hangs over, turned about the vertical.
struct Footprint {
  Vector2 center = Vector2::Zero();     ///< on the table, in the world [m]
  double yaw_deg = 0;                   ///< of its first side from the world's x axis
  Vector2 half_size = Vector2::Zero();  ///< [m]

  /// In order around it [m].
  std::array<Vector2, 4> corners() const;
};

/// By how much two footprints are apart; 0 if they have a point in common [m].
double GapBetween(const Footprint& a, const Footprint& b);

/// The least one, along the object's own sides, about all its pieces as the object stands at
/// `X_WB`.
Footprint FootprintOf(const scene::ObjectSpec& object, const RigidTransform& X_WB);

}  // namespace smile::layout
