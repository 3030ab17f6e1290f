#include "math/camera_projection.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace smile {

namespace {

void CheckSize(int width_px, int height_px) {
  constexpr int kMaxSize = 8192;
  if (width_px >= 1 && width_px <= kMaxSize && height_px >= 1 && height_px <= kMaxSize) return;
  throw std::invalid_argument("image size is " + std::to_string(width_px) + "x" +
                              std::to_string(height_px) + ", expected 1 to " +
                              std::to_string(kMaxSize) + " pixels each");
}

/// Returns the focal length [px] of a camera that sees `angle` [rad] across `size_px`.
double FocalLength(const std::string& direction, int size_px, double angle) {
  // Half of the image is f tan(angle / 2) wide.
  if (angle > 0 && angle < std::numbers::pi) return 0.5 * size_px / std::tan(0.5 * angle);
  throw std::invalid_argument(direction + " field of view is " + std::to_string(angle) +
                              " rad, expected between 0 and pi");
}

/// Returns intrinsics with square pixels and the principal point in the middle of the image.
CameraIntrinsics Centered(int width_px, int height_px, double focal_length) {
  // Pixel centers are at halves, so the middle of the image is at half of its size.
  return {.width_px = width_px,
          .height_px = height_px,
          .fx = focal_length,
          .fy = focal_length,
          .cx = 0.5 * width_px,
          .cy = 0.5 * height_px};
}

}  // namespace

CameraIntrinsics CameraIntrinsics::FromVerticalFieldOfView(int width_px, int height_px,
                                                           double angle) {
  CheckSize(width_px, height_px);
  return Centered(width_px, height_px, FocalLength("vertical", height_px, angle));
}

CameraIntrinsics CameraIntrinsics::FromHorizontalFieldOfView(int width_px, int height_px,
                                                             double angle) {
  CheckSize(width_px, height_px);
  return Centered(width_px, height_px, FocalLength("horizontal", width_px, angle));
}

RigidTransform LookAt(const Vector3& p_WC, const Vector3& p_WQ, const Vector3& up_in_world) {
  const Vector3 sight = p_WQ - p_WC;
  if (sight.norm() == 0) throw std::invalid_argument("a camera cannot look at its own position");
  const Vector3 z = sight.normalized();
  // z forward and y down, so the right side is forward x up.
  Vector3 x = z.cross(up_in_world);
  // The line of sight is parallel to the up direction.
  if (x.norm() < 1e-9 * up_in_world.norm()) {
    // A view straight down or up: the default direction (z) has no projection into the image.
    x = Vector3::UnitX();
    if (std::abs(z.dot(x)) > 1e-9)
      throw std::invalid_argument("the up direction of the camera points forward");
  }
  x.normalize();
  Matrix3 R_WC;
  R_WC << x, z.cross(x), z;
  return {R_WC, p_WC};
}

Eigen::Vector2d ProjectToPixel(const CameraIntrinsics& intrinsics, const Vector3& p_CQ) {
  return {intrinsics.cx + intrinsics.fx * p_CQ.x() / p_CQ.z(),
          intrinsics.cy + intrinsics.fy * p_CQ.y() / p_CQ.z()};
}

}  // namespace smile
