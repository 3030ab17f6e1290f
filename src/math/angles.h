#pragma once

#include <numbers>

#include "math/rigid_transform.h"

namespace smile {

constexpr double DegreesToRadians(double angle_deg) { return angle_deg * std::numbers::pi / 180.0; }
constexpr double RadiansToDegrees(double angle) { return angle * 180.0 / std::numbers::pi; }

/// Scene files and recordings write a rotation as three angles (a, b, c) [deg]: about the fixed x
/// axis by a, then the fixed y axis by b, then the fixed z axis by c. R = Rz(c) Ry(b) Rx(a).
Matrix3 RotationFromFixedAxes(const Vector3& angles_deg);

/// The angles (a, b, c) [deg] that RotationFromFixedAxes() turns into `R`: a and c within (-180,
/// 180], b within [-90, 90]. When |R31| > 0.999999 only a - c or a + c is determined; then a = 0.
Vector3 FixedAxesAngles(const Matrix3& R);

/// The rotation vector (axis times angle [rad], angle within [0, pi]) that turns `from` into `to`,
/// along the common outer frame: to = exp(v) * from.
Vector3 RotationVectorBetween(const Quaternion& from, const Quaternion& to);

}  // namespace smile
