#pragma once

#include "interchange/exported_motion.h"
#include "interchange/exported_text.h"

namespace smile::interchange {

/// Returns what is seen of a scene, and how it moves, as a binary glTF 2.0 file
/// (https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html), with y up.
///
/// Each object, and each link of the robot, is a node of its name in meters along SMILE's axes,
/// below one node that turns z up. What appears and vanishes has a scale of 1 or 0, in steps.
/// Cameras are nodes, and the light is a directional one (KHR_lights_punctual).
ExportedText ToGltf(const ExportedScene& scene);

}  // namespace smile::interchange
