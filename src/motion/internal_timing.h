#pragma once

#include <span>
#include <vector>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// The factor by which the cubic between two points must take longer to keep the limits of
/// velocity, times `speed`, and acceleration; below 1 when it could be faster. Exact: a motion that
/// takes k times as long has velocities 1/k and accelerations 1/k^2 times as large.
double SlownessNeeded(const TrajectoryPoint& from, const TrajectoryPoint& to,
                      std::span<const JointLimits> limits, double speed);

/// Makes the whole motion so much longer that it keeps these limits everywhere; one that keeps
/// them stays as it is.
void SlowDownToLimits(std::span<const JointLimits> limits, double speed,
                      std::vector<TrajectoryPoint>* points);

/// The steepest slope between these slopes of two neighbouring straight lines with which a cubic
/// through their ends does not swing over them: 0 where they differ in sign.
/// Source: F. N. Fritsch, J. Butland, "A method for constructing local monotone piecewise cubic
/// interpolants" (1984), with the spans of time as weights.
double CalmSlope(double before, double after, double seconds_before, double seconds_after);

/// @throws std::invalid_argument unless 0 < speed <= 1.
void CheckSpeed(double speed);

/// @throws std::invalid_argument if counts differ, or a value is not finite or beyond its limits,
///         naming `what` it is, for example `waypoint 2`.
void CheckConfiguration(std::span<const double> q, std::span<const JointLimits> limits,
                        const std::string& what);

}  // namespace smile::motion
