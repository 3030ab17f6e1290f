#pragma once

#include <vector>

#include "motion/channels.h"
#include "recording/recording.h"
#include "recording/time_range.h"

namespace smile::recording {

/// Returns the motion of the robot in a part of a recording: its positions at the first tick, at
/// the first tick that is at least k / `points_per_second` later (for each k), and at the last;
/// velocities are derived from the positions. A joint that is pushed slightly beyond its limit is
/// reported at the limit.
///
/// @param channels  channels of the recording's robot to report.
/// @throws InputError if the recording has no robot or its trace cannot be read;
///         std::invalid_argument if the range is not within the recording.
motion::JointTrajectory JointMotionOf(const Recording& recording,
                                      const std::vector<motion::TrajectoryChannel>& channels,
                                      const TimeRange& range, double points_per_second);

}  // namespace smile::recording
