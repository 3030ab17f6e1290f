#pragma once

#include <optional>
#include <vector>

#include "scene/scene_spec.h"

namespace smile::task {

/// Symmetry of a body B: the rotations about its origin after which it looks the same.
struct Symmetry {
  bool is_sphere = false;       ///< any turn
  std::optional<Vector3> axis;  ///< any rotation about this direction of B; nullopt: none
  bool is_reversible = false;   ///< the axis may also point the other way
  std::vector<Matrix3> turns{Matrix3::Identity()};  ///< used if there is no axis

  /// Returns the smallest angle between two orientations of the body, up to its symmetry, within
  /// [0, pi] [rad].
  double AngleBetween(const Matrix3& R_WA, const Matrix3& R_WB) const;
  /// Returns the smallest tilt between two orientations, up to the symmetry and any turn about the
  /// vertical [rad].
  double TiltBetween(const Matrix3& R_WA, const Matrix3& R_WB) const;
  /// Returns the angles of turns about the vertical that lead from A to B if both stand alike
  /// [rad]; empty if every angle does.
  std::vector<double> YawsBetween(const Matrix3& R_WA, const Matrix3& R_WB) const;
};

/// Returns the symmetry of the visible object. Spheres and cylinders are round, and so are frustums
/// and rings of 24 sides and more, and composites of round parts about one axis through the origin.
/// Frustums and rings of fewer sides have one rotation per side. All other shapes are tested with
/// the 24 rotations of a cube: a cube looks the same after all 24, a plank of square section
/// after 8.
Symmetry SymmetryOf(const scene::ObjectSpec& object);

}  // namespace smile::task
