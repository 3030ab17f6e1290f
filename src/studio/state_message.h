#pragma once

#include "base/json.h"
#include "library/playback.h"
#include "sim/simulation.h"

namespace smile::studio {

/// Returns the part of a state message about a live simulation: tick, hands, uses of tools,
/// controls, missing objects, attention, the robot. In units, rounded to visible precision.
Json DescribeLive(const sim::Simulation& simulation);

/// Returns the same part for playback: hands are empty, and controls and robot are omitted.
Json DescribeShown(const library::Playback& playback);

}  // namespace smile::studio
