#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/camera_projection.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::app {

/// The names FindView() knows: `eye` and the presets for people.
std::vector<std::string> ViewNames();

/// A camera by name: `eye` is the robot's, when its joints are at `q`; `close` shows the scene's
/// objects where they are at the start, the others the whole table.
/// @throws std::invalid_argument if there is no such camera.
CameraView FindView(std::string_view name, const sim::Simulation& simulation,
                    std::span<const double> q, const sim::EyeSpec& size);

}  // namespace smile::app
