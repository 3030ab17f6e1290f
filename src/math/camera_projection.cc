#include "math/camera_projection.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace smile {

CameraIntrinsics CameraIntrinsics::FromVerticalFieldOfView(int width_px, int height_px,
                                                           double angle) {
  constexpr int kMaxSize = 8192;
  if (width_px < 1 || width_px > kMaxSize || height_px < 1 || height_px > kMaxSize) {
    throw std::invalid_argument("image size is " + std::to_string(width_px) + "x" +
                                std::to_string(height_px) + ", expected 1 to " +
                                std::to_string(kMaxSize) + " pixels each");
  }
  if (!(angle > 0 && angle < std::numbers::pi)) {
    throw std::invalid_argument("vertical field of view is " + std::to_string(angle) +
                                " rad, expected between 0 and pi");
  }
  const double focal_length = 0.5 * height_px / std::tan(0.5 * angle);
  return {.width_px = width_px,
          .height_px = height_px,
          .fx = focal_length,
          .fy = focal_length,
          .cx = 0.5 * width_px,
          .cy = 0.5 * height_px};
}

RigidTransform LookAt(const Vector3& p_WC, const Vector3& p_WQ) {
  const Vector3 sight = p_WQ - p_WC;
  if (sight.norm() == 0) throw std::invalid_argument("a camera cannot look at its own position");
  const Vector3 z = sight.normalized();
  Vector3 x = z.cross(Vector3::UnitZ());
  // Straight up or down: the image's right side is world x.
  x = x.norm() < 1e-9 ? Vector3::UnitX() : Vector3(x.normalized());
  Matrix3 R_WC;
  R_WC << x, z.cross(x), z;
  return {R_WC, p_WC};
}

Eigen::Vector2d ProjectToPixel(const CameraIntrinsics& intrinsics, const Vector3& p_CQ) {
  return {intrinsics.cx + intrinsics.fx * p_CQ.x() / p_CQ.z(),
          intrinsics.cy + intrinsics.fy * p_CQ.y() / p_CQ.z()};
}

}  // namespace smile
