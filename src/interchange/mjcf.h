#pragma once

#include "interchange/exported_text.h"

namespace smile::interchange {

/// Returns the world as MJCF, the format of MuJoCo
/// (https://mujoco.readthedocs.io/en/stable/XMLreference.html), in one file with all meshes.
///
/// Bodies that joints hold on each other become a tree; joints that close a loop become
/// constraints. Solids collide and are drawn in group 3, which MuJoCo's viewer hides at first; what
/// SMILE draws is in group 2. Each joint of the robot has a velocity servo of its name.
ExportedText ToMjcf(const ExportedWorld& world);

}  // namespace smile::interchange
