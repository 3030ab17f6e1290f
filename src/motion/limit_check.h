#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// What of a joint a limit is about.
enum class LimitedQuantity { kPosition, kVelocity, kAcceleration };

/// `position`, `velocity`, `acceleration`.
std::string_view NameOf(LimitedQuantity quantity);

/// One joint goes too far, too fast, or changes its speed too quickly.
struct LimitBreach {
  double seconds = 0;  ///< the moment at which it is worst, since the trajectory's start
  std::string joint_name;
  LimitedQuantity quantity = LimitedQuantity::kPosition;
  double value = 0;     ///< then and there, with its sign [rad, rad/s, rad/s2; m for what slides]
  double limit = 0;     ///< the one that it is beyond
  bool slides = false;  ///< in m, else it turns, in rad

  bool operator==(const LimitBreach&) const = default;
};

/// `left_e1: velocity is 2 rad/s, expected at most 1.5 rad/s`; the moment is not told.
std::string ToString(const LimitBreach& breach);

/// Each joint's worst breach of each of its limits, in order of time. Exact: it looks at the
/// extremes of the cubics, not at samples. What rounding alone explains (a share of 1e-9) is none.
///
/// @param limits  one per joint of the trajectory.
/// @throws std::invalid_argument if counts differ, a number is not finite, or the points are not
///         in order of time.
std::vector<LimitBreach> CheckLimits(const JointTrajectory& trajectory,
                                     std::span<const JointLimits> limits);

}  // namespace smile::motion
