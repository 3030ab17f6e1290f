#pragma once

#include <optional>

#include "model/eye.h"
#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::recording {

/// Returns the visual state at a recorded tick, for the visual model of `model`, that of the
/// recording's scene and robot.
scene::VisualState VisualStateAt(const TraceTick& moment, const model::Model& model);

/// Returns the sample of a recorded tick for a camera; a robot's camera is where the joints of that
/// tick put it.
model::ViewSample ViewSampleAt(const TraceTick& moment, const model::Model& model,
                               const model::EyeSpec& spec);

/// Returns the eye that took a recording's pictures; nullopt if it has none.
std::optional<model::EyeSpec> EyeOf(const DemoInfo& info);

}  // namespace smile::recording
