#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesh/primitives.h"
#include "scene/visual_model.h"

namespace smile::studio {

/// The meshes a page needs to draw a visual model: of all that is neither block, cylinder nor
/// sphere. Equal ones are there once. Never changes, so that any thread may ask.
class PageMeshes {
 public:
  explicit PageMeshes(const scene::VisualModel& model);

  /// nullopt for what a page draws by itself.
  std::optional<std::size_t> NumberOf(const scene::VisualShape& shape) const;
  std::size_t size() const { return meshes_.size(); }
  /// As docs/studio-protocol.md has them; nullopt if there is no such mesh.
  std::optional<std::string> Bytes(std::size_t mesh) const;

 private:
  std::vector<mesh::UnitMesh> meshes_;
  std::map<mesh::UnitMesh, std::size_t> number_of_;
};

/// `u32 corners, u32 triangles`, corners, normals, triangles: little-endian.
std::string BytesOf(const mesh::TriangleMesh& mesh);

}  // namespace smile::studio
