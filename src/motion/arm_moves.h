#pragma once

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "motion/inverse_kinematics.h"

namespace smile::motion {

/// A motion in joint space through waypoints, from rest to rest, without stopping between: along
/// cubics that do not overshoot them, so that what lies between two waypoints lies within the
/// limits when they do, and as fast as the limits allow everywhere. Where a joint turns back it
/// rests for a moment. Through two waypoints it is MoveStraight().
///
/// @param waypoints  at least one; each one value per joint, within limits [rad or m]. Two equal
///                   ones in a row count once.
/// @param speed      0 < speed <= 1, share of the limits of velocity.
/// @returns points, among them the waypoints; within the limits of velocity and acceleration.
/// @throws std::invalid_argument if there is none, or one is not as described.
std::vector<TrajectoryPoint> MoveThrough(std::span<const std::vector<double>> waypoints,
                                         std::span<const JointLimits> limits, double speed = 1);

struct LineOptions {
  double speed = 1;  ///< 0 < speed <= 1, share of the joints' limits of velocity
  double tool_speed = std::numeric_limits<double>::infinity();  ///< > 0, at most [m/s]
  /// The tool may turn about its own axis z on the way and at the end.
  bool any_turn = false;
};

/// Why the tool cannot go along a line.
struct LineFault {
  double share = 0;     ///< how far it comes, from 0 to 1
  RigidTransform X_WG;  ///< where it cannot go on to
  std::string reason;

  bool operator==(const LineFault&) const = default;
};

/// How far the tool may be off its line [m].
inline constexpr double kLineTolerance = 0.0005;

/// Moves the tool from where it is along a straight line to a pose, turning evenly on the way
/// (slerp; with `any_turn` the shortest way that brings its axis there). It starts and ends at rest
/// and is everywhere as fast as the joints' limits and `tool_speed` allow. The joints follow
/// without jumps; the line is given up where they cannot.
///
/// @param q_from     one value per joint of the arm, within limits [rad or m].
/// @param X_WG_goal  where it ends.
/// @throws std::invalid_argument if `q_from` is not as described, the goal is no pose, or an option
///         is out of range.
std::variant<JointTrajectory, LineFault> MoveAlongLine(const ArmKinematics& arm,
                                                       std::span<const double> q_from,
                                                       const RigidTransform& X_WG_goal,
                                                       const LineOptions& options = {});

}  // namespace smile::motion
