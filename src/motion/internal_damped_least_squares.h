#pragma once

#include "motion/inverse_kinematics.h"

namespace smile::motion {

/// Configuration of an arm, in fixed storage.
using ArmVector =
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, robot::kMaxArmJoints, 1>;

/// Damped least squares solver: iterates from one start, within limits, until the goal is met or
/// the error no longer decreases.
class DampedLeastSquares {
 public:
  /// Prepares a solver. All arguments must outlive it.
  DampedLeastSquares(const ArmKinematics& arm, const RigidTransform& X_WG_goal,
                     const IkOptions& options);

  /// Improves `q`, which must lie within limits.
  /// @param iterations_left  counted down; the solver stops at 0.
  /// @returns true if the goal is met.
  bool Run(ArmVector* q, int* iterations_left) const;

 private:
  struct Error {
    /// translation and rotation to the goal, along the world's axes
    Eigen::Matrix<double, 6, 1> weighted;
    bool is_met = false;
  };
  Error ErrorOf(const RigidTransform& X_WG) const;
  void HoldAtLimits(const ArmVector& q, const Eigen::Matrix<double, 6, 1>& error,
                    ArmJacobian* J) const;

  const ArmKinematics* arm_;
  RigidTransform X_WG_goal_;
  Quaternion q_WG_goal_;
  IkOptions options_;
};

/// Check arguments; see SolveInverseKinematics().
/// @throws std::invalid_argument
void CheckGoal(const RigidTransform& X_WG_goal);
void CheckOptions(const IkOptions& options);
/// Returns `q` clamped to the limits.
/// @throws std::invalid_argument if the count is wrong or a value is not finite.
ArmVector WithinLimits(const ArmKinematics& arm, std::span<const double> q);

}  // namespace smile::motion
