#include "math/angles.h"

#include <cmath>

namespace smile {

Matrix3 RotationFromFixedAxes(const Vector3& angles_deg) {
  // Quarter turns are exact: a block rotated by 90 degrees stays axis-aligned to the last bit.
  const auto sine = [](double angle_deg) {
    // remainder() is exact, so angles beyond a full turn lose no digits.
    const double quarter = std::remainder(angle_deg, 360.0) / 90.0;
    if (quarter == std::round(quarter)) return quarter == 1 ? 1.0 : quarter == -1 ? -1.0 : 0.0;
    return std::sin(DegreesToRadians(angle_deg));
  };
  const auto cosine = [&sine](double angle_deg) { return sine(angle_deg + 90.0); };
  const double sa = sine(angles_deg.x()), ca = cosine(angles_deg.x());
  const double sb = sine(angles_deg.y()), cb = cosine(angles_deg.y());
  const double sc = sine(angles_deg.z()), cc = cosine(angles_deg.z());
  // Rz(c) Ry(b) Rx(a), written out.
  Matrix3 R;
  R << cb * cc, sa * sb * cc - ca * sc, ca * sb * cc + sa * sc,  //
      cb * sc, sa * sb * sc + ca * cc, ca * sb * sc - sa * cc,   //
      -sb, sa * cb, ca * cb;
  return R;
}

Vector3 FixedAxesAngles(const Matrix3& R) {
  constexpr double kGimbalLock = 0.999999;
  Vector3 angles;
  if (std::abs(R(2, 0)) > kGimbalLock) {
    // b = +-90 degrees: a and c turn about the same axis; all of it goes to c.
    angles = {0.0, R(2, 0) < 0 ? std::numbers::pi / 2 : -std::numbers::pi / 2,
              std::atan2(-R(0, 1), R(1, 1))};
  } else {
    angles = {std::atan2(R(2, 1), R(2, 2)), -std::asin(R(2, 0)), std::atan2(R(1, 0), R(0, 0))};
  }
  return angles * (180.0 / std::numbers::pi);
}

Quaternion SmallestRotation(const Vector3& from, const Vector3& to) {
  return Quaternion::FromTwoVectors(from, to);
}

Vector3 RotationVectorBetween(const Quaternion& from, const Quaternion& to) {
  // q and -q are the same rotation; the one with w >= 0 has the smaller angle.
  Quaternion turn = to * from.conjugate();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  const double sine_of_half = turn.vec().norm();
  // Small angles: sin(x/2) = x/2. The quotient below would be 0 / 0.
  if (sine_of_half < 1e-12) return 2.0 * turn.vec();
  return turn.vec() * (2.0 * std::atan2(sine_of_half, turn.w()) / sine_of_half);
}

}  // namespace smile
