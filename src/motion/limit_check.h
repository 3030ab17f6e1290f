#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// Quantity of a joint that is limited.
enum class LimitedQuantity { kPosition, kVelocity, kAcceleration };

/// Returns `position`, `velocity` or `acceleration`.
std::string_view NameOf(LimitedQuantity quantity);

/// Violation of a limit by one joint.
struct LimitBreach {
  double seconds = 0;  ///< time of the worst violation, since the trajectory's start
  std::string joint_name;
  LimitedQuantity quantity = LimitedQuantity::kPosition;
  double value = 0;     ///< signed value at that time [rad, rad/s, rad/s2, or m instead of rad]
  double limit = 0;     ///< the limit that is exceeded
  bool slides = false;  ///< true for m, false for rad

  bool operator==(const LimitBreach&) const = default;
};

/// Returns, for example, `left_e1: velocity is 2 rad/s, expected at most 1.5 rad/s`, without the
/// time.
std::string ToString(const LimitBreach& breach);

/// Returns each joint's worst violation of each of its limits, in order of time. Exact: it
/// evaluates the extremes of the cubics instead of samples. Excess due to rounding (a fraction of
/// 1e-9) does not count.
///
/// @param limits  one per joint of the trajectory.
/// @throws std::invalid_argument if counts differ, a number is not finite, or the points are not
///         in order of time.
std::vector<LimitBreach> CheckLimits(const JointTrajectory& trajectory,
                                     std::span<const JointLimits> limits);

}  // namespace smile::motion
