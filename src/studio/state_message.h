#pragma once

#include "base/json.h"
#include "sim/simulation.h"

namespace smile::studio {

/// Of a state message what a live simulation says: tick, hands, controls, what is gone, what
/// matters, the robot. In units, rounded to what can be seen.
Json DescribeLive(const sim::Simulation& simulation);

/// The same of a moment at which nothing can be grasped.
Json DescribeNothingLive(std::uint64_t tick);

}  // namespace smile::studio
