#include "layout/footprint.h"

#include <algorithm>
#include <limits>

#include "math/angles.h"
#include "scene/bounds.h"

namespace smile::layout {
namespace {

/// Returns true if a line along one of a's sides separates the two (one half of the separating axis
/// test).
bool IsPartedAlongSides(const Footprint& a, const Footprint& b) {
  const Eigen::Matrix2d R_AW = Eigen::Rotation2Dd(-DegreesToRadians(a.yaw_deg)).toRotationMatrix();
  Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vector2& corner : b.corners()) {
    const Vector2 p_AQ = R_AW * (corner - a.center);
    low = low.cwiseMin(p_AQ);
    high = high.cwiseMax(p_AQ);
  }
  return (low.array() > a.half_size.array()).any() || (high.array() < -a.half_size.array()).any();
}

/// Returns the distance of a point outside from a rectangle [m].
double DistanceTo(const Footprint& footprint, const Vector2& p_WQ) {
  // In the rectangle's own axes; only the excess over its half size counts, per axis.
  const Vector2 p_FQ = Eigen::Rotation2Dd(-DegreesToRadians(footprint.yaw_deg)).toRotationMatrix() *
                       (p_WQ - footprint.center);
  return (p_FQ.cwiseAbs() - footprint.half_size).cwiseMax(0.0).norm();
}

}  // namespace

std::array<Vector2, 4> Footprint::corners() const {
  const Eigen::Matrix2d R_WF = Eigen::Rotation2Dd(DegreesToRadians(yaw_deg)).toRotationMatrix();
  const Vector2 along = R_WF.col(0) * half_size.x(), across = R_WF.col(1) * half_size.y();
  return {center + along + across, center - along + across, center - along - across,
          center + along - across};
}

double GapBetween(const Footprint& a, const Footprint& b) {
  // Two convex polygons are apart exactly if a side of one of them separates them.
  if (!IsPartedAlongSides(a, b) && !IsPartedAlongSides(b, a)) return 0;
  // The shortest distance of two disjoint convex polygons is at a corner of one of them.
  double gap = std::numeric_limits<double>::infinity();
  for (const Vector2& corner : a.corners()) gap = std::min(gap, DistanceTo(b, corner));
  for (const Vector2& corner : b.corners()) gap = std::min(gap, DistanceTo(a, corner));
  return gap;
}

Footprint FootprintOf(const scene::ObjectSpec& object, const RigidTransform& X_WB) {
  // Bounds in a frame that is rotated by the yaw only: tilts become part of the size.
  const double yaw_deg = FixedAxesAngles(X_WB.rotation()).z();
  const RigidTransform X_WF(RotationFromFixedAxes({0, 0, yaw_deg}), Vector3::Zero());
  const scene::Bounds bounds =
      scene::BoundsOf(scene::SolidsOf(object.whole), X_WF.inverse() * X_WB);
  if (bounds.is_empty()) return {.center = X_WB.translation().head<2>(), .yaw_deg = yaw_deg};
  return {.center = (X_WF * bounds.center()).head<2>(),
          .yaw_deg = yaw_deg,
          .half_size = bounds.size().head<2>() / 2};
}

}  // namespace smile::layout
