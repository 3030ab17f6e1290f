#pragma once

#include <vector>

#include "math/rigid_transform.h"

namespace smile::task {

/// A shift on the table and a turn about the vertical.
struct TableMotion {
  double angle = 0;  ///< [rad]
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  RigidTransform transform() const;
};

/// The motion with this turn that carries `from` to where `to` is on the ground; heights stay.
TableMotion MotionTo(double angle, const Vector3& from, const Vector3& to);

/// Where a point was, and where it is now.
struct PointPair {
  Vector3 p_WA, p_WB;
};

/// The motion that carries the first points nearest to the second ones, by least squares on the
/// ground. Pairs that lie above one another say nothing about the turn: then `angle` stays.
TableMotion FitMotion(const std::vector<PointPair>& pairs, double angle);

}  // namespace smile::task
