#pragma once

#include "math/rigid_transform.h"

namespace smile {

/// How a pinhole camera turns points into pixels.
///
/// The camera frame C has x right, y down, z forward. A point p_CQ [m] appears at
/// u = cx + fx * x / z, v = cy + fy * y / z; pixel (0, 0) is the top left one and its centre is at
/// u = v = 0.5.
struct CameraIntrinsics {
  int width_px = 640;
  int height_px = 480;
  double fx = 0, fy = 0;  ///< focal lengths [px]
  double cx = 0, cy = 0;  ///< where the axis meets the image [px]
  double near = 0.01;     ///< nothing nearer is seen [m]
  double far = 10.0;      ///< nothing farther is seen [m]

  /// Square pixels, axis in the middle of the image.
  /// @throws std::invalid_argument unless sizes are 1 to 8192 and the angle is in (0, pi).
  static CameraIntrinsics FromVerticalFieldOfView(int width_px, int height_px, double angle);
  /// The same for the angle from left to right.
  static CameraIntrinsics FromHorizontalFieldOfView(int width_px, int height_px, double angle);

  bool operator==(const CameraIntrinsics&) const = default;
};

/// A camera somewhere in the world.
struct CameraView {
  CameraIntrinsics intrinsics;
  RigidTransform X_WC;

  bool operator==(const CameraView&) const = default;
};

/// The pose of a camera at `p_WC` that looks at `p_WQ` with the image's top towards `up_in_world`.
/// Straight up or down at a vertical `up_in_world`, the image's right side is world +x.
/// @throws std::invalid_argument if the two points coincide, or another `up_in_world` points from
///         one to the other.
RigidTransform LookAt(const Vector3& p_WC, const Vector3& p_WQ,
                      const Vector3& up_in_world = Vector3::UnitZ());

/// Pixel coordinates (u, v) of a point in the camera frame with z > 0.
Eigen::Vector2d ProjectToPixel(const CameraIntrinsics& intrinsics, const Vector3& p_CQ);

}  // namespace smile
