#pragma once

#include <optional>

#include "record/recording.h"
#include "record/trace.h"
#include "sim/eye.h"

namespace smile::record {

/// A recorded moment, for the visual model of `stage`, a simulation of the recording's scene and
/// robot that need not run.
scene::VisualState VisualStateAt(const TraceTick& moment, const sim::Simulation& stage);

/// The same as a camera saw it: one of the robot's is where its joints were.
sim::Sight SightAt(const TraceTick& moment, const sim::Simulation& stage, const sim::EyeSpec& spec);

/// The eye that took a recording's pictures; nullopt if it has none.
std::optional<sim::EyeSpec> EyeOf(const DemoInfo& info);

}  // namespace smile::record
