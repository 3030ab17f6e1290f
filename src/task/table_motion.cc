#include "task/table_motion.h"

#include <cmath>

namespace smile::task {

RigidTransform TableMotion::transform() const {
  return {Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(),
          Vector3(shift.x(), shift.y(), 0)};
}

TableMotion MotionTo(double angle, const Vector3& from, const Vector3& to) {
  return {angle, to.head<2>() - Eigen::Rotation2Dd(angle) * from.head<2>()};
}

// Rigid registration in the plane: centroids determine the shift; the angle that minimizes the sum
// of squared distances has a closed form (the planar case of the orthogonal Procrustes problem).
TableMotion FitMotion(const std::vector<PointPair>& pairs, double angle) {
  // Below this sum of squared distances from the centroid, positions do not determine an angle.
  constexpr double kSpread = 1e-4;  // [m2]
  Vector3 center_a = Vector3::Zero(), center_b = center_a;
  for (const PointPair& pair : pairs) {
    center_a += pair.p_WA / static_cast<double>(pairs.size());
    center_b += pair.p_WB / static_cast<double>(pairs.size());
  }
  // Sums of dot and cross products: proportional to the cosine and sine of the optimal angle.
  double along = 0, across = 0, spread = 0;
  for (const PointPair& pair : pairs) {
    const Vector3 a = pair.p_WA - center_a, b = pair.p_WB - center_b;
    along += a.x() * b.x() + a.y() * b.y();
    across += a.x() * b.y() - a.y() * b.x();
    spread += a.head<2>().squaredNorm();
  }
  if (spread > kSpread) angle = std::atan2(across, along);
  return MotionTo(angle, center_a, center_b);
}

}  // namespace smile::task
