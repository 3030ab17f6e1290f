#pragma once

#include <string>

#include "interchange/exported_text.h"

namespace smile::interchange {

/// Returns the world as URDF (http://wiki.ros.org/urdf/XML), a format of single robots: one tree of
/// links from a link `world`, with bodies that nothing holds on floating joints. Positions of
/// joints count from the present ones. Meshes are STL files beside it.
///
/// @param mesh_folder  name of their folder, relative to that of the file.
ExportedText ToUrdf(const ExportedWorld& world, const std::string& mesh_folder);

}  // namespace smile::interchange
