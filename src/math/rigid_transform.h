#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace smile {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// Pose X_AB of a frame B in a frame A: a rotation R_AB and the position p_AB of B's origin [m].
class RigidTransform {
 public:
  RigidTransform() = default;
  RigidTransform(const Matrix3& R_AB, const Vector3& p_AB) : rotation_(R_AB), translation_(p_AB) {}
  RigidTransform(const Quaternion& q_AB, const Vector3& p_AB)
      : RigidTransform(q_AB.toRotationMatrix(), p_AB) {}
  explicit RigidTransform(const Vector3& p_AB) : translation_(p_AB) {}

  const Matrix3& rotation() const { return rotation_; }
  const Vector3& translation() const { return translation_; }
  /// Returns the rotation as a quaternion of unit length with w >= 0.
  Quaternion quaternion() const {
    Quaternion q(rotation_);
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    return q.normalized();
  }

  RigidTransform inverse() const {
    return {Matrix3(rotation_.transpose()), -(rotation_.transpose() * translation_)};
  }
  /// Returns X_AC = X_AB * X_BC.
  RigidTransform operator*(const RigidTransform& X_BC) const {
    return {Matrix3(rotation_ * X_BC.rotation_), *this * X_BC.translation_};
  }
  /// Returns p_AQ = X_AB * p_BQ.
  Vector3 operator*(const Vector3& p_BQ) const { return rotation_ * p_BQ + translation_; }

  bool operator==(const RigidTransform& other) const {
    return rotation_ == other.rotation_ && translation_ == other.translation_;
  }

 private:
  Matrix3 rotation_ = Matrix3::Identity();
  Vector3 translation_ = Vector3::Zero();
};

}  // namespace smile
