#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion/joint_trajectory.h"

// Requirements for trajectories from files and clients, independent of the robot.

namespace smile::motion {

/// Upper bounds of a trajectory.
inline constexpr std::size_t kMaxTrajectoryPoints = 10'000, kMaxTrajectoryJoints = 64;
inline constexpr double kMaxTrajectorySeconds = 86400;
/// Upper bound of positions and velocities [rad, m, per s].
inline constexpr double kMaxTrajectoryNumber = 1e6;

/// Returns the fault in the time of a point that follows another one, or none (null); empty if it
/// has no fault.
std::string FaultOfTime(double seconds, const TrajectoryPoint* before);
/// Returns the fault in the names of a trajectory's joints; empty if there is no fault.
std::string FaultOfNames(const std::vector<std::string>& names);

/// Checks names, times, counts and bounds.
/// @param has_velocities  false while its points have none.
/// @throws std::invalid_argument with what was found and expected.
void CheckShape(const JointTrajectory& trajectory, bool has_velocities = true);

/// Computes velocities from positions: central differences, one-sided at both ends, limited such
/// that the cubics stay between the positions that they connect. The motion therefore never exceeds
/// the points. Source: F. N. Fritsch, R. E. Carlson, "Monotone Piecewise Cubic Interpolation"
/// (1980), section 4.
/// @param trajectory  its points in strict order of time.
void SetVelocitiesFromPositions(JointTrajectory* trajectory);

/// Scales time: the trajectory then takes `factor` times as long along the same path.
/// @param factor  > 0.
void ScaleTime(double factor, JointTrajectory* trajectory);

}  // namespace smile::motion
