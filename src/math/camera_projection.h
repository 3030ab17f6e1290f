#pragma once

#include "math/rigid_transform.h"

namespace smile {

/// Intrinsic parameters of a pinhole camera.
///
/// The camera frame C has x right, y down, z forward. A point p_CQ [m] appears at u = cx + fx * x /
/// z, v = cy + fy * y / z; pixel (0, 0) is the top left one and its center is at u = v = 0.5.
struct CameraIntrinsics {
  int width_px = 640;
  int height_px = 480;
  double fx = 0, fy = 0;  ///< focal lengths [px]
  double cx = 0, cy = 0;  ///< principal point [px]
  double near = 0.01;     ///< near clipping distance [m]
  double far = 10.0;      ///< far clipping distance [m]

  /// Makes intrinsics with square pixels and the axis in the middle of the image.
  /// @throws std::invalid_argument unless sizes are 1 to 8192 and the angle [rad] is in (0, pi).
  static CameraIntrinsics FromVerticalFieldOfView(int width_px, int height_px, double angle);
  /// The same for the horizontal angle.
  static CameraIntrinsics FromHorizontalFieldOfView(int width_px, int height_px, double angle);

  bool operator==(const CameraIntrinsics&) const = default;
};

/// Intrinsics and pose of a camera.
struct CameraView {
  CameraIntrinsics intrinsics;
  RigidTransform X_WC;

  bool operator==(const CameraView&) const = default;
};

/// Returns the pose of a camera at `p_WC` that looks at `p_WQ` with the image's top towards
/// `up_in_world`. If both are vertical, the image's right side is world +x.
/// @throws std::invalid_argument if the two points coincide, or another `up_in_world` is along the
///         line of sight.
RigidTransform LookAt(const Vector3& p_WC, const Vector3& p_WQ,
                      const Vector3& up_in_world = Vector3::UnitZ());

/// Returns the pixel coordinates (u, v) of a point in the camera frame with z > 0.
Eigen::Vector2d ProjectToPixel(const CameraIntrinsics& intrinsics, const Vector3& p_CQ);

}  // namespace smile
