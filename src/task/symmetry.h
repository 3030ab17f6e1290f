#pragma once

#include <optional>
#include <vector>

#include "scene/scene_spec.h"

namespace smile::task {

/// The turns of a body B about its origin after which it looks as before.
struct Symmetry {
  bool is_sphere = false;       ///< any turn
  std::optional<Vector3> axis;  ///< any turn about this direction of B; nullopt: none
  bool is_reversible = false;   ///< it may also point the other way
  std::vector<Matrix3> turns{Matrix3::Identity()};  ///< where there is no axis

  /// How far apart two orientations of the body look, within [0, pi] [rad].
  double AngleBetween(const Matrix3& R_WA, const Matrix3& R_WB) const;
  /// How far, at least, one is tilted against the other, whatever turn about the vertical there is
  /// between them [rad].
  double TiltBetween(const Matrix3& R_WA, const Matrix3& R_WB) const;
  /// The turns about the vertical that may lead from one to the other where both stand alike: none
  /// where every turn does [rad].
  std::vector<double> YawsBetween(const Matrix3& R_WA, const Matrix3& R_WB) const;
};

/// Of what can be seen of an object. Spheres and cylinders are round, and so are frustums and rings
/// of 24 sides and more; those with fewer come back after each side. All else is tried on the
/// quarter turns about its own axes, and the halves and thirds that these make up: a cube comes
/// back after all 24, a plank of square section after 8.
Symmetry SymmetryOf(const scene::ObjectSpec& object);

}  // namespace smile::task
