#pragma once

#include "motion/inverse_kinematics.h"

namespace smile::motion {

/// A configuration of an arm, without memory of its own.
using ArmVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxArmJoints, 1>;

/// Damped least squares solver: iterates from one start, within limits, until the goal is met or
/// the error no longer decreases.
class DampedLeastSquares {
 public:
  /// All must outlive this.
  DampedLeastSquares(const ArmKinematics& arm, const RigidTransform& X_WG_goal,
                     const IkOptions& options);

  /// Improves `q`, which lies within limits.
  /// @param iterations_left  counted down; it ends at 0.
  /// @returns true when the goal is met.
  bool Run(ArmVector* q, int* iterations_left) const;

 private:
  struct Error {
    Eigen::Matrix<double, 6, 1> weighted;  ///< what is missing: along the world's axes
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

/// @throws std::invalid_argument; see SolveInverseKinematics().
void CheckGoal(const RigidTransform& X_WG_goal);
void CheckOptions(const IkOptions& options);
/// `q`, moved onto the limits where it is beyond them.
/// @throws std::invalid_argument if the count is wrong or a value is not finite.
ArmVector WithinLimits(const ArmKinematics& arm, std::span<const double> q);

}  // namespace smile::motion
