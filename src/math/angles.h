#pragma once

#include <numbers>

#include "math/rigid_transform.h"

namespace smile {

constexpr double DegreesToRadians(double angle_deg) { return angle_deg * std::numbers::pi / 180.0; }
constexpr double RadiansToDegrees(double angle) { return angle * 180.0 / std::numbers::pi; }

/// Returns the rotation of three angles (a, b, c) [deg] as in scene files and recordings: about the
/// fixed x axis by a, then the fixed y axis by b, then the fixed z axis by c. R = Rz(c) Ry(b)
/// Rx(a).
Matrix3 RotationFromFixedAxes(const Vector3& angles_deg);

/// Returns the angles (a, b, c) [deg] of a rotation: a and c within (-180, 180], b within [-90,
/// 90]. If |R31| > 0.999999, only a - c or a + c is determined; then a = 0.
Vector3 FixedAxesAngles(const Matrix3& R);

/// Returns the smallest rotation that turns the direction `from` to the direction `to`; of opposite
/// directions, about an axis at a right angle to them. (Eigen's, compiled once: it contains a
/// singular value decomposition.)
Quaternion SmallestRotation(const Vector3& from, const Vector3& to);

/// Returns the rotation vector (axis times angle [rad], angle within [0, pi]) that rotates `from`
/// to `to`, along the common outer frame: to = exp(v) * from.
Vector3 RotationVectorBetween(const Quaternion& from, const Quaternion& to);

}  // namespace smile
