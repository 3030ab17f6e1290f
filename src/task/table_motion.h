#pragma once

#include <vector>

#include "math/rigid_transform.h"

namespace smile::task {

/// Rigid motion on the table: a turn about the vertical through the origin, then a shift along x
/// and y [m].
struct TableMotion {
  double angle = 0;  ///< [rad]
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  RigidTransform transform() const;
};

/// Returns the motion with this angle that carries `from` onto `to` in the plane of the table;
/// heights stay.
TableMotion MotionTo(double angle, const Vector3& from, const Vector3& to);

/// Positions of a point before and after a motion, in the world [m].
struct PointPair {
  Vector3 p_WA, p_WB;
};

/// Returns the least-squares motion from the first points to the second ones, in the plane of the
/// table. Pairs that lie above one another do not determine an angle: then `angle` is used.
TableMotion FitMotion(const std::vector<PointPair>& pairs, double angle);

}  // namespace smile::task
