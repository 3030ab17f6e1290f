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
  Json extras;  ///< extras of the node; an empty object if it has none
  Color color;
  /// Vertices and triangles as in the file; without convex pieces. Nodes with the same mesh share
  /// it.
  std::shared_ptr<const scene::CustomMesh> mesh;
};

/// Reads a GLB or glTF file in pieces: one per primitive of each root node, in the order of the
/// file. Axes are those of the file. Each node must have a mesh and may have a name and extras;
/// triangles have indices and a material.
///
/// @throws InputError whose file is `path`: missing file, limits exceeded, truncated, damaged, or
///         content other than described.
std::vector<MeshPiece> ImportPieces(const std::filesystem::path& path,
                                    const MeshLimits& limits = {});

}  // namespace smile::mesh
