// One attempt of the inverse kinematics; motion/inverse_kinematics.cc chooses the starts. Each
// iteration linearizes the pose error at the present configuration and moves the joints so that the
// error would vanish, damped near singular configurations, where an undamped step would be huge.

#include "motion/internal_damped_least_squares.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/wording.h"
#include "math/angles.h"

namespace smile::motion {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Weight of position errors: one meter counts as this many radians, about the inverse of an arm's
/// length.
constexpr double kRadiansPerMeter = 2;
/// Damping: this fraction of the squared error, and never zero, so that a singular arm stays still
/// instead of jumping. Tuned for success within few iterations over random poses.
constexpr double kDampingShare = 0.02;
constexpr double kLeastDamping = 1e-10;
/// Greatest motion of a joint in one iteration [rad or m]: the linearization does not hold beyond.
constexpr double kLongestStep = 0.8;
/// An attempt ends after this many iterations without reducing the error by the factor.
constexpr int kPatience = 8;
constexpr double kClearlySmaller = 0.8;

/// Returns the rotation vector that rotates the z axis of a frame to a direction, by the smaller
/// angle [rad].
Vector3 TurnBetween(const Matrix3& R_from, const Vector3& to) {
  const Vector3 from = R_from.col(2);
  const Vector3 axis = from.cross(to);
  const double sine = axis.norm(), cosine = from.dot(to);
  if (sine > 1e-12) return axis * (std::atan2(sine, cosine) / sine);
  // Opposite directions: any perpendicular axis works.
  return cosine > 0 ? Vector3(axis) : Vector3(R_from.col(0) * std::numbers::pi);
}

}  // namespace

void CheckGoal(const RigidTransform& X_WG_goal) {
  // Callers compute goals with a few multiplications of rotations, whose rounding stays far below.
  constexpr double kLoose = 1e-6;
  const Matrix3& R = X_WG_goal.rotation();
  const bool is_pose = X_WG_goal.translation().allFinite() && R.allFinite() &&
                       (R * R.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() < kLoose &&
                       R.determinant() > 0;
  if (!is_pose)
    throw std::invalid_argument("the goal is not a pose: not finite, or not a rotation");
}

void CheckOptions(const IkOptions& options) {
  const auto check_tolerance = [](const char* name, double value) {
    if (value > 0 && std::isfinite(value)) return;
    throw std::invalid_argument(std::string(name) + " is " + NumberText(value) +
                                ", expected above 0");
  };
  check_tolerance("position_tolerance", options.position_tolerance);
  check_tolerance("angle_tolerance", options.angle_tolerance);
  if (options.max_iterations < 1 || options.max_iterations > 1'000'000) {
    throw std::invalid_argument("max_iterations is " + std::to_string(options.max_iterations) +
                                ", expected 1 to 1000000");
  }
}

ArmVector WithinLimits(const ArmKinematics& arm, std::span<const double> q) {
  if (static_cast<int>(q.size()) != arm.num_joints()) {
    throw std::invalid_argument("q has " + std::to_string(q.size()) + " values, expected " +
                                std::to_string(arm.num_joints()));
  }
  ArmVector within(arm.num_joints());
  for (int i = 0; i < arm.num_joints(); ++i) {
    if (!std::isfinite(q[i])) throw std::invalid_argument("q is not finite");
    within[i] = std::clamp(q[i], arm.limits()[i].lower, arm.limits()[i].upper);
  }
  return within;
}

DampedLeastSquares::DampedLeastSquares(const ArmKinematics& arm, const RigidTransform& X_WG_goal,
                                       const IkOptions& options)
    : arm_(&arm), X_WG_goal_(X_WG_goal), q_WG_goal_(X_WG_goal.quaternion()), options_(options) {}

DampedLeastSquares::Error DampedLeastSquares::ErrorOf(const RigidTransform& X_WG) const {
  const Vector3 displacement = X_WG_goal_.translation() - X_WG.translation();
  // Rotation vectors along the world's axes, as the Jacobian's angular rows are.
  const Vector3 rotation = options_.any_rotation ? Vector3::Zero()
                           : options_.any_turn
                               ? TurnBetween(X_WG.rotation(), X_WG_goal_.rotation().col(2))
                               : RotationVectorBetween(Quaternion(X_WG.rotation()), q_WG_goal_);
  Error error;
  error.weighted << displacement * kRadiansPerMeter, rotation;
  error.is_met = displacement.norm() <= options_.position_tolerance &&
                 rotation.norm() <= options_.angle_tolerance;
  return error;
}

/// Removes the columns of joints that are at a limit and would move beyond it, so that the others
/// take over their share.
void DampedLeastSquares::HoldAtLimits(const ArmVector& q, const Vector6& error,
                                      ArmJacobian* J) const {
  for (int i = 0; i < arm_->num_joints(); ++i) {
    const JointLimits& limit = arm_->limits()[i];
    // The projection of the error on the joint's column: the direction in which the joint would
    // reduce it.
    const double push = J->col(i).dot(error);
    if ((q[i] <= limit.lower && push < 0) || (q[i] >= limit.upper && push > 0)) {
      J->col(i).setZero();
    }
  }
}

bool DampedLeastSquares::Run(ArmVector* q, int* iterations_left) const {
  ArmJacobian J;
  const auto configuration = [q] { return std::span<const double>(q->data(), q->size()); };
  // Levenberg-Marquardt step: dq = J^T (J J^T + lambda I)^-1 error, with lambda proportional to the
  // squared error. The 6 x 6 form does not grow with the number of joints, and is always positive
  // definite.
  double best = HUGE_VAL;
  for (int waited = 0; waited < kPatience; ++waited) {
    const RigidTransform X_WG = arm_->ToolPose(configuration(), &J);
    const Error error = ErrorOf(X_WG);
    if (error.is_met) return true;
    // Counted across all attempts: the caller's limit bounds the time of the whole search.
    if (--*iterations_left < 0) return false;
    const double size = error.weighted.squaredNorm();
    // Progress: the count of iterations without it starts again.
    if (size < kClearlySmaller * best) {
      best = size;
      waited = -1;
    }

    // The rows get the same weight as the error.
    J.topRows<3>() *= kRadiansPerMeter;
    if (options_.any_rotation) {
      J.bottomRows<3>().setZero();
    } else if (options_.any_turn) {
      // Rotation about the tool's own axis is free: remove it from the Jacobian.
      const Vector3 z = X_WG.rotation().col(2);
      J.bottomRows<3>() -= z * (z.transpose() * J.bottomRows<3>()).eval();
    }
    // After weighting and projection, since the signs of the columns' projections depend on both.
    HoldAtLimits(*q, error.weighted, &J);
    Matrix6 A = (kDampingShare * size + kLeastDamping) * Matrix6::Identity();
    for (int i = 0; i < J.cols(); ++i) A.noalias() += J.col(i) * J.col(i).transpose();
    // A is a sum of squares plus a positive multiple of the identity, so Cholesky cannot fail.
    const Vector6 pull = A.llt().solve(error.weighted);
    ArmVector step = J.transpose() * pull;
    const double longest = step.cwiseAbs().maxCoeff();
    // All joints are scaled alike, to keep the direction; the clamp after it acts on single joints.
    if (longest > kLongestStep) step *= kLongestStep / longest;
    for (int i = 0; i < step.size(); ++i) {
      (*q)[i] = std::clamp((*q)[i] + step[i], arm_->limits()[i].lower, arm_->limits()[i].upper);
    }
  }
  return false;
}

}  // namespace smile::motion
