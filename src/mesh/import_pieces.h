#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/json.h"
#include "math/color.h"
#include "mesh/import_mesh.h"

namespace smile::mesh {

/// A surface of one color, fixed to a named node of a glTF file.
struct MeshPiece {
  std::string node;
  Json extras;  ///< of the node; an empty object if it has none
  Color color;
  /// Vertices and triangles as the file has them; without convex pieces. Nodes with the same mesh
  /// share it.
  std::shared_ptr<const scene::CustomMesh> mesh;
};

/// Reads a GLB or glTF file piece by piece: one for each primitive of each root node, in the order
/// of the file. Axes are those of the file. Nodes have a mesh, a name and extras; triangles have
/// indices and a material.
///
/// @throws InputError whose file is `path`: no such file, more bytes than the limits allow, cut
///         short, damaged, or content other than described.
std::vector<MeshPiece> ImportPieces(const std::filesystem::path& path,
                                    const MeshLimits& limits = {});

}  // namespace smile::mesh
