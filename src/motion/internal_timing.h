#pragma once

#include <span>
#include <vector>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// Returns the factor by which the time of the cubic between two points must be scaled to keep the
/// limits of velocity, times `speed`, and acceleration; below 1 when it could be faster. Exact: a
/// motion that takes k times as long has velocities 1/k and accelerations 1/k^2 times as large.
double SlownessNeeded(const TrajectoryPoint& from, const TrajectoryPoint& to,
                      std::span<const JointLimits> limits, double speed);

/// Scales the time of the whole motion such that it keeps these limits everywhere; a motion that
/// keeps them is not changed.
void SlowDownToLimits(std::span<const JointLimits> limits, double speed,
                      std::vector<TrajectoryPoint>* points);

/// Returns the tangent at the point between two secants with these slopes for which the
/// interpolating cubics are monotone where the data are: 0 where the slopes differ in sign. Source:
/// F. N. Fritsch, J. Butland, "A method for constructing local monotone piecewise cubic
/// interpolants" (1984), with the spans of time as weights.
double MonotoneTangent(double before, double after, double seconds_before, double seconds_after);

/// @throws std::invalid_argument unless 0 < speed <= 1.
void CheckSpeed(double speed);

/// @throws std::invalid_argument if counts differ, or a value is not finite or beyond its limits,
///         naming `what` it is, for example `waypoint 2`.
void CheckConfiguration(std::span<const double> q, std::span<const JointLimits> limits,
                        const std::string& what);

}  // namespace smile::motion
