#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "math/camera_projection.h"
#include "model/eye.h"
#include "scene/scene_spec.h"

namespace smile::picture {

/// The names of views for people.
std::vector<std::string> ViewNames();

/// A view that stays where it is. By name: `close` shows the scene's objects where they are at
/// the start, the others the whole table. Or anywhere: `FROM:TO[:FOV]` stands at one point, looks
/// at another [x,y,z in units of the scene], and sees so many degrees from top to bottom.
/// @param cameras    other names there are, for the message.
/// @param has_robot  true when a robot is to be seen, which `close` then looks at from the front.
/// @throws std::invalid_argument if there is no such view.
CameraView FindView(std::string_view camera, const scene::SceneSpec& scene,
                    const model::EyeSpec& size, const std::vector<std::string>& cameras,
                    bool has_robot = false);

}  // namespace smile::picture
