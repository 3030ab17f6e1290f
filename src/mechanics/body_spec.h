#pragma once

#include <optional>
#include <vector>

#include "scene/solid.h"

namespace smile::mechanics {

/// Definition of a rigid body and its initial pose.
struct BodySpec {
  std::vector<scene::Solid> solids;  ///< collision solids, in the body's own frame B
  scene::MassProperties mass;        ///< mass 0 = static
  RigidTransform X_WB;               ///< initial pose
  double friction = 0.6;
  double restitution = 0.0;
  /// Rolling resistance: distance from the middle of the footprint to the point of support [m].
  /// Unset: 0 for a body of blocks only, otherwise 1 mm.
  std::optional<double> rolling_friction;
  /// Fraction of the angular velocity lost per second; unset: WorldConfig::damping.
  std::optional<double> angular_damping;

  bool operator==(const BodySpec&) const = default;
};

}  // namespace smile::mechanics
