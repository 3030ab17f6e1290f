#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesh/primitives.h"
#include "scene/visual_model.h"

namespace smile::page {

/// Meshes that a page needs to draw a visual model: of all shapes except blocks, cylinders and
/// spheres. Equal meshes are listed once. Immutable, so that any thread may read.
class PageMeshes {
 public:
  explicit PageMeshes(const scene::VisualModel& model);

  /// Returns the index of a shape's mesh; nullopt for shapes that a page draws by itself.
  std::optional<std::size_t> NumberOf(const scene::VisualShape& shape) const;
  std::size_t size() const { return meshes_.size(); }
  /// Returns the bytes of a mesh (docs/studio-protocol.md); nullopt if it does not exist.
  std::optional<std::string> Bytes(std::size_t mesh) const;

 private:
  std::vector<mesh::UnitMesh> meshes_;
  std::map<mesh::UnitMesh, std::size_t> number_of_;
};

/// Returns `u32 corners, u32 triangles`, corners, normals, triangles: little-endian.
std::string BytesOf(const mesh::TriangleMesh& mesh);

}  // namespace smile::page
