#pragma once

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "motion/inverse_kinematics.h"

namespace smile::motion {

/// Returns a motion in joint space through waypoints, from rest to rest, without stops in between.
/// It follows cubics that do not overshoot the waypoints, so it lies within the limits if the
/// waypoints do, and is everywhere as fast as the limits allow. A joint that reverses rests for a
/// moment. Two waypoints give MoveStraight().
///
/// @param waypoints  at least one; each one value per joint, within limits [rad or m]. Equal
///                   neighbors count once.
/// @param speed      0 < speed <= 1, fraction of the limits of velocity.
/// @returns points, among them the waypoints; within the limits of velocity and acceleration.
/// @throws std::invalid_argument if there is no waypoint, or one is not as described.
std::vector<TrajectoryPoint> MoveThrough(std::span<const std::vector<double>> waypoints,
                                         std::span<const JointLimits> limits, double speed = 1);

/// Options of MoveAlongLine().
struct LineOptions {
  double speed = 1;  ///< 0 < speed <= 1, fraction of the joints' limits of velocity
  double tool_speed = std::numeric_limits<double>::infinity();  ///< > 0, upper bound [m/s]
  /// True if the tool may rotate about its own z axis, on the way and at the end.
  bool any_turn = false;
  /// True if the tool may rotate in any way; see IkOptions.
  bool any_rotation = false;
};

/// Reason why the tool cannot follow a line.
struct LineFault {
  double fraction = 0;  ///< fraction of the line that it can follow, 0 to 1
  RigidTransform X_WG;  ///< first pose that it cannot reach
  std::string reason;

  bool operator==(const LineFault&) const = default;
};

/// Greatest deviation of the tool from its line [m].
inline constexpr double kLineTolerance = 0.0005;

/// Returns a motion of the tool along a straight line to a pose, with rotation proportional to
/// distance (slerp; with `any_turn` the shortest rotation that aligns its axis). It starts and ends
/// at rest and is everywhere as fast as the joints' limits and `tool_speed` allow. The joints move
/// continuously; the line is refused where they cannot.
///
/// @param q_from     one value per joint of the arm, within limits [rad or m].
/// @param X_WG_goal  final pose of the tool.
/// @throws std::invalid_argument if `q_from` is not as described, the goal is not a pose, or an
///         option is out of range.
std::variant<JointTrajectory, LineFault> MoveAlongLine(const ArmKinematics& arm,
                                                       std::span<const double> q_from,
                                                       const RigidTransform& X_WG_goal,
                                                       const LineOptions& options = {});

}  // namespace smile::motion
