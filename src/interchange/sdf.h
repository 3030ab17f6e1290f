#pragma once

#include <string>

#include "interchange/exported_text.h"

namespace smile::interchange {

/// Returns the world as SDFormat 1.9, the format of Gazebo (http://sdformat.org/spec).
///
/// Bodies that joints hold together are the links of one model, which has the name of its first
/// body; static ones among them are fixed on the world. Positions of joints count from the present
/// ones. Meshes are files beside it.
///
/// @param mesh_folder  name of their folder, relative to that of the file.
ExportedText ToSdf(const ExportedWorld& world, const std::string& mesh_folder);

}  // namespace smile::interchange
