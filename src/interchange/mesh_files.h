#pragma once

#include <string>
#include <utility>
#include <vector>

#include "interchange/mesh_table.h"

namespace smile::interchange {

/// Returns a mesh as a binary STL file, whose unit is the meter.
///
/// Source: the format's 80 bytes of title, a count of triangles, and for each triangle its normal,
/// its three corners (all float32) and two bytes of attributes.
std::string ToStl(const NamedMesh& mesh);

/// Returns the name of the file of a mesh, `FOLDER/NAME.stl`.
std::string MeshFileName(const std::string& folder, const std::string& mesh);

/// Returns all meshes as files in a folder, for formats that cannot contain them.
std::vector<std::pair<std::string, std::string>> MeshFilesOf(const MeshTable& meshes,
                                                             const std::string& folder);

}  // namespace smile::interchange
