#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// Place of a path in joint space, with the path parameter s.
struct PathPlace {
  double s = 0;           ///< rising from place to place
  Eigen::VectorXd q;      ///< [rad or m]
  Eigen::VectorXd dq_ds;  ///< path derivative
  /// Second path derivatives; they may differ before and after the place.
  Eigen::VectorXd d2q_ds2_before, d2q_ds2_after;
};

/// Returns the time-optimal trajectory along a path from rest to rest, within the limits of
/// velocity, times `speed`, and of acceleration, and with a path velocity ds/dt of at most
/// `top_rate`. Source: H. Pham, Q.-C. Pham, "A New Approach to Time-Optimal Path Parameterization
/// Based on Reachability Analysis" (2018).
///
/// @param path      at least two places, all within the limits of position; neighbors differ.
/// @param top_rate  of s [1/s]; may be infinite.
/// @returns a point for each place. All limits hold exactly, also between the places: the whole
///          trajectory is slowed down slightly where necessary.
std::vector<TrajectoryPoint> TimeParameterize(
    const std::vector<PathPlace>& path, std::span<const JointLimits> limits, double speed,
    double top_rate = std::numeric_limits<double>::infinity());

}  // namespace smile::motion
