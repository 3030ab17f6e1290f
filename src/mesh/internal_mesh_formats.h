#pragma once

#include <string_view>

#include "mesh/internal_triangle_soup.h"

namespace smile::mesh {

// One reader per format, which adds the triangles of a file to the soup. All throw BadMesh for a
// file that is damaged, truncated or of another format.

/// Reads STL, text or binary; content after the first solid is ignored.
void ReadStl(std::string_view bytes, TriangleSoup* soup);

/// Reads `v` and `f` lines of OBJ; a face of more than three corners becomes a fan of triangles.
void ReadObj(std::string_view bytes, TriangleSoup* soup);

/// Reads all meshes of a glTF scene, each in its place.
/// @param max_bytes  limit for all files together.
void ReadGltf(std::string_view bytes, const OpenNeighbour& open, std::size_t max_bytes,
              TriangleSoup* soup);

/// Reads all meshes of a DAE file, each in its place. The direction that its `up_axis` names
/// becomes Y, unless the soup keeps axes as written.
void ReadCollada(std::string_view bytes, TriangleSoup* soup);

}  // namespace smile::mesh
