#pragma once

#include "base/json.h"
#include "library/playback.h"
#include "sim/simulation.h"

namespace smile::studio {

/// Of a state message what a live simulation says: tick, hands, controls, what is gone, what
/// matters, the robot. In units, rounded to what can be seen.
Json DescribeLive(const sim::Simulation& simulation);

/// The same of the moment of a recording that is shown: nothing can be grasped, and of controls and
/// the robot nothing is told.
Json DescribeShown(const library::Playback& playback);

}  // namespace smile::studio
