#pragma once

#include <span>
#include <string>
#include <vector>

#include "robot/robot_model.h"

namespace smile::motion {

/// Positions and velocities of some joints at one moment.
struct TrajectoryPoint {
  double seconds = 0;              ///< since the trajectory's start
  std::vector<double> positions;   ///< one per joint [rad or m]
  std::vector<double> velocities;  ///< one per joint [rad/s or m/s]

  bool operator==(const TrajectoryPoint&) const = default;
};

/// Motion of some joints of a robot: between its points each joint follows the cubic that has their
/// positions and velocities. Planners make it, recordings contain it, robots follow it.
struct JointTrajectory {
  std::vector<std::string> joint_names;
  std::vector<TrajectoryPoint> points;  ///< in order of time, the first at 0

  double seconds() const { return points.empty() ? 0.0 : points.back().seconds; }
  bool operator==(const JointTrajectory&) const = default;
};

/// Returns the state at `seconds`; before the start the first point and after the end the last one,
/// at rest.
/// @throws std::invalid_argument if it has no points.
TrajectoryPoint SampleAt(const JointTrajectory& trajectory, double seconds);

/// Limits of a joint.
struct JointLimits {
  double lower = 0, upper = 0;  ///< [rad or m]
  double max_velocity = 0;      ///< > 0 [rad/s or m/s]
  double max_acceleration = 0;  ///< > 0 [rad/s2 or m/s2]
  bool slides = false;          ///< true for m, false for rad
};

/// Robot descriptions specify no accelerations: each joint may reach its full speed within this
/// time. Chosen to be gentle enough for held objects.
inline constexpr double kSecondsToFullSpeed = 0.5;

/// Returns the limits of some joints, given by their indices.
/// @throws std::invalid_argument if there is no such joint.
std::vector<JointLimits> LimitsOf(const robot::RobotModel& model, std::span<const int> joints);

/// Returns the fastest straight motion in joint space from rest to rest: all joints start, reach
/// their greatest speed, and stop together. It stays within the limits of velocity, times `speed`,
/// and of acceleration.
///
/// @param speed  0 < speed <= 1, fraction of the limits of velocity.
/// @returns three or four points, whose cubics are the motion exactly; one if nothing moves.
/// @throws std::invalid_argument if counts differ, a value is not finite, `from` or `to` breaks a
///         limit of position, or `speed` is out of range.
std::vector<TrajectoryPoint> MoveStraight(std::span<const double> from, std::span<const double> to,
                                          std::span<const JointLimits> limits, double speed = 1);

}  // namespace smile::motion
