#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "math/camera_projection.h"
#include "model/eye.h"
#include "scene/scene_spec.h"

namespace smile::picture {

/// Returns the names of views for people.
std::vector<std::string> ViewNames();

/// Returns a fixed view. By name: `close` shows the scene's objects at their initial poses, the
/// others the whole table. Or anywhere: `FROM:TO[:FOV]` is at one point, looks at another [x,y,z in
/// units of the scene], with a vertical field of view in degrees.
/// @param cameras  other valid names, for the message.
/// @param has_robot  true if a robot is visible, which `close` then shows from the front.
/// @throws std::invalid_argument if the view does not exist.
CameraView FindView(std::string_view camera, const scene::SceneSpec& scene,
                    const model::EyeSpec& size, const std::vector<std::string>& cameras,
                    bool has_robot = false);

}  // namespace smile::picture
