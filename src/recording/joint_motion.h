#pragma once

#include <vector>

#include "motion/channels.h"
#include "recording/recording.h"
#include "recording/time_range.h"

namespace smile::recording {

/// How the robot moved in a part of a recording: its positions at the first tick, at the first tick
/// that is at least k / `points_per_second` later, and at the last; velocities are those of the
/// positions. A joint that its limit holds may stand a little beyond it; it is told to be at it.
///
/// @param channels  of the recording's robot; what is to be told.
/// @throws InputError if the recording has no robot or its trace cannot be read;
///         std::invalid_argument if the range is none of the recording.
motion::JointTrajectory JointMotionOf(const Recording& recording,
                                      const std::vector<motion::Channel>& channels,
                                      const TimeRange& range, double points_per_second);

}  // namespace smile::recording
