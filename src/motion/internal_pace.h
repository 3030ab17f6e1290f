#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// A place of a path in joint space, which runs along a parameter s.
struct PathPlace {
  double s = 0;                             ///< rising from place to place
  Eigen::VectorXd q;                        ///< [rad or m]
  Eigen::VectorXd slope;                    ///< dq/ds
  Eigen::VectorXd bend_before, bend_after;  ///< d2q/ds2; a path may bend suddenly
};

/// Runs along a path from rest to rest, everywhere as fast as the limits of velocity, times
/// `speed`, and of acceleration allow, and no faster than `top_rate`. Source: H. Pham, Q.-C. Pham,
/// "A New Approach to Time-Optimal Path Parameterization Based on Reachability Analysis" (2018).
///
/// @param path      at least two places, all within the limits of position; no neighbours are
/// alike.
/// @param top_rate  of s [1/s]; may be infinite.
/// @returns a point for each place, within all limits exactly: what the places cannot see between
///          them is paid for by making the whole a little longer.
std::vector<TrajectoryPoint> RunAlong(const std::vector<PathPlace>& path,
                                      std::span<const JointLimits> limits, double speed,
                                      double top_rate = std::numeric_limits<double>::infinity());

}  // namespace smile::motion
