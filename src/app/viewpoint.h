#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/camera_projection.h"
#include "scene/scene_spec.h"
#include "sim/eye.h"

namespace smile::app {

/// The camera that goes with the robot's head.
inline constexpr const char* kEye = "eye";

/// The names of cameras: `eye` and the presets for people.
std::vector<std::string> ViewNames();

/// A camera that stays where it is. By name: `close` shows the scene's objects where they are at
/// the start, the others the whole table. Or anywhere: `FROM:TO[:FOV]` stands at one point, looks
/// at another [x,y,z in units of the scene], and sees so many degrees from top to bottom.
/// @returns nullopt for `eye`, which sim::EyeView() knows.
/// @throws std::invalid_argument if there is no such camera.
std::optional<CameraView> FindView(std::string_view camera, const scene::SceneSpec& scene,
                                   const sim::EyeSpec& size);

}  // namespace smile::app
