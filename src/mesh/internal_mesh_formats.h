#pragma once

#include <string_view>

#include "mesh/internal_triangle_soup.h"

namespace smile::mesh {

// One reader per format: each adds the triangles of a file to the soup.
// All throw BadMesh for a file that is damaged, cut short or not of the format.

/// Text or binary; what comes after the first solid is not read.
void ReadStl(std::string_view bytes, TriangleSoup* soup);

/// `v` and `f`; a face of more than three corners becomes a fan of triangles.
void ReadObj(std::string_view bytes, TriangleSoup* soup);

/// All meshes of the scene, each in its place. @param max_bytes  of all files together.
void ReadGltf(std::string_view bytes, const OpenNeighbour& open, std::size_t max_bytes,
              TriangleSoup* soup);

/// The same of a DAE file; what its `up_axis` says is up is along Y, unless the soup wants it as it
/// is written.
void ReadCollada(std::string_view bytes, TriangleSoup* soup);

}  // namespace smile::mesh
