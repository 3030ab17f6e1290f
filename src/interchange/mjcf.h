#pragma once

#include <string>
#include <vector>

#include "interchange/exported_world.h"

namespace smile::interchange {

/// A world in the format of one simulator.
struct ExportedText {
  std::string text;
  /// What has no counterpart in the format, in words; ExportedWorld::left_out among it.
  std::vector<std::string> left_out;
};

/// Returns the world as MJCF, the format of MuJoCo
/// (https://mujoco.readthedocs.io/en/stable/XMLreference.html), in one file with all meshes.
///
/// Bodies that joints hold on each other become a tree; joints that close a loop become
/// constraints. Solids collide and are drawn in group 3, which MuJoCo's viewer hides at first; what
/// SMILE draws is in group 2. Each joint of the robot has a velocity servo of its name.
ExportedText ToMjcf(const ExportedWorld& world);

}  // namespace smile::interchange
