#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion/joint_trajectory.h"

// What trajectories that come from outside must be like, whatever robot they are for.

namespace smile::motion {

/// Longer trajectories, and those of more joints, are nobody's.
inline constexpr std::size_t kMaxTrajectoryPoints = 10'000, kMaxTrajectoryJoints = 64;
inline constexpr double kMaxTrajectorySeconds = 86400;
/// Of positions and velocities [rad, m, per s].
inline constexpr double kMaxTrajectoryNumber = 1e6;

/// What is wrong with the time of a point that follows upon another one, or upon none, in words;
/// empty: nothing.
std::string FaultOfTime(double seconds, const TrajectoryPoint* before);
/// What is wrong with the names of a trajectory's joints.
std::string FaultOfNames(const std::vector<std::string>& names);

/// Makes sure that names, times and counts are as they should be, and within the bounds.
/// @param has_velocities  false while its points have none.
/// @throws std::invalid_argument saying what was found and what was expected.
void CheckShape(const JointTrajectory& trajectory, bool has_velocities = true);

/// Gives every point the velocities that its neighbors tell: central differences, one-sided at both
/// ends, as far as that keeps the cubics between the positions that they join. So the motion never
/// goes beyond the points.
/// Source: F. N. Fritsch, R. E. Carlson, "Monotone Piecewise Cubic Interpolation" (1980),
/// section 4.
/// @param trajectory  its points in strict order of time.
void SetVelocitiesFromPositions(JointTrajectory* trajectory);

/// Scales the time of the trajectory: it takes `factor` times as long along the same path.
/// @param factor  > 0.
void ScaleTime(double factor, JointTrajectory* trajectory);

}  // namespace smile::motion
