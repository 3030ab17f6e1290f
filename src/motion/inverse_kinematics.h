#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/arm_kinematics.h"

namespace smile::motion {

/// Options of the inverse kinematics.
struct IkOptions {
  double position_tolerance = 1e-6;  ///< > 0 [m]
  double angle_tolerance = 1e-6;     ///< > 0 [rad]
  /// True if the rotation of the tool about its own z axis is free: only its position and direction
  /// matter.
  bool any_turn = false;
  /// True if the whole rotation of the tool is free: only its position matters. Arms of fewer than
  /// six joints cannot take every rotation, and arms of fewer than five not every direction.
  bool any_rotation = false;
  int max_iterations = 2000;  ///< of all attempts together; 1 to 1000000
  std::uint64_t seed = 1;     ///< of the starts of further attempts
};

/// Returns joint angles that bring the tool to a wanted pose.
///
/// Damped least squares on the geometric Jacobian, started at `q_start`. If that fails, further
/// attempts start elsewhere, at first near `q_start`, later anywhere within limits; of the first
/// few solutions, the nearest to `q_start` is returned. Sources: S. R. Buss, "Introduction to
/// Inverse Kinematics with Jacobian Transpose, Pseudoinverse and Damped Least Squares methods"
/// (2004); T. Sugihara, "Solvability-Unconcerned Inverse Kinematics by the Levenberg-Marquardt
/// Method" (2011), for the damping that shrinks with the error.
///
/// @param X_WG_goal  wanted pose of the tool G [m].
/// @param q_start    one value per joint of the arm [rad or m]; finite; clamped to the limits.
/// @returns a configuration within limits; nullopt if none was found within tolerance, which is an
///          ordinary result.
/// @throws std::invalid_argument if `q_start` has the wrong size, a number is not finite, the goal
///         is not a pose, or an option is out of range.
/// The same inputs give the same result. Reentrant.
[[nodiscard]] std::optional<std::vector<double>> SolveInverseKinematics(
    const ArmKinematics& arm, const RigidTransform& X_WG_goal, std::span<const double> q_start,
    const IkOptions& options = {});

/// Returns the reason why SolveInverseKinematics() finds no configuration, for people: whether the
/// tool would reach the place with a free turn, with a free rotation, or not at all.
/// Same arguments. Searches again, as long.
std::string WhyUnreachable(const ArmKinematics& arm, const RigidTransform& X_WG_goal,
                           std::span<const double> q_start, const IkOptions& options = {});

}  // namespace smile::motion
