#pragma once

#include <optional>

#include "model/eye.h"
#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::recording {

/// A recorded moment, for the visual model of `model`, that of the recording's scene and robot.
scene::VisualState VisualStateAt(const TraceTick& moment, const model::Model& model);

/// The same as a camera saw it: one of the robot's is where its joints were.
model::Sight SightAt(const TraceTick& moment, const model::Model& model,
                     const model::EyeSpec& spec);

/// The eye that took a recording's pictures; nullopt if it has none.
std::optional<model::EyeSpec> EyeOf(const DemoInfo& info);

}  // namespace smile::recording
