#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "motion/arm_kinematics.h"

namespace smile::motion {

struct IkOptions {
  double position_tolerance = 1e-6;  ///< > 0 [m]
  double angle_tolerance = 1e-6;     ///< > 0 [rad]
  /// The tool may be turned about its own axis z as the arm likes: only where it is and where it
  /// points matter.
  bool any_turn = false;
  int max_iterations = 2000;  ///< of all attempts together; 1 to 1000000
  std::uint64_t seed = 1;     ///< of the places where further attempts start
};

/// Finds joint angles that bring the tool to a wanted pose.
///
/// Damped least squares on the geometric Jacobian, started at `q_start`. When that ends nowhere, it
/// is tried again from elsewhere, at first near `q_start`, later anywhere within limits, and the
/// nearest to `q_start` of the first few answers is taken.
/// Sources: S. R. Buss, "Introduction to Inverse Kinematics with Jacobian Transpose, Pseudoinverse
/// and Damped Least Squares methods" (2004); T. Sugihara, "Solvability-Unconcerned Inverse
/// Kinematics by the Levenberg-Marquardt Method" (2011), for the damping that shrinks with the
/// error.
///
/// @param X_WG_goal  wanted pose of the tool G [m].
/// @param q_start    one value per joint of the arm [rad or m]; finite; outside the limits it
///                   counts as on them.
/// @returns a configuration within limits; nullopt when none was found within tolerance, which is
///          an ordinary answer.
/// @throws std::invalid_argument if `q_start` has the wrong size, something is not finite, the goal
///         is no pose, or an option is out of range.
/// Same inputs give the same answer. Touches no shared state.
[[nodiscard]] std::optional<std::vector<double>> SolveInverseKinematics(
    const ArmKinematics& arm, const RigidTransform& X_WG_goal, std::span<const double> q_start,
    const IkOptions& options = {});

}  // namespace smile::motion
