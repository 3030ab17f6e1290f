#pragma once

#include <cstddef>
#include <map>

#include "camera/internal_gl.h"
#include "camera/internal_pieces.h"

namespace smile::camera::internal {

/// Unit meshes on the graphics card, uploaded when first drawn.
///
/// Vertex shaders read: 0 position, 1 normal (of the unit mesh), 2 to 4 the rows of the instance's
/// matrix, 5 its color as shown on a screen, 6 its object id, 7 glow: 1 or 0.
class MeshStore {
 public:
  /// Draws with the program in use; pieces that share a unit mesh are drawn in one call.
  /// @param clip_from_world  of the program; pieces beside the picture are left out.
  void Draw(const std::vector<Piece>& pieces, const Eigen::Matrix4f& clip_from_world);
  /// Returns the box around a unit mesh.
  const Eigen::AlignedBox3f& BoxOf(const mesh::UnitMesh& unit_mesh) {
    return MeshFor(unit_mesh).box;
  }

 private:
  struct UploadedMesh {
    VertexArray vertex_array;
    Buffer corners, triangles, instances;
    GLsizei num_indices = 0;
    Eigen::AlignedBox3f box;
    std::vector<Instance> waiting;  // to be drawn
  };

  /// Limit on cached meshes, since a long session may show any number of hulls.
  static constexpr std::size_t kMaxMeshes = 4096;

  static UploadedMesh Upload(const mesh::UnitMesh& unit_mesh);

  UploadedMesh& MeshFor(const mesh::UnitMesh& unit_mesh);

  std::map<mesh::UnitMesh, UploadedMesh> meshes_;
};

/// Source with which every vertex shader begins: the inputs above, and `vec3 PositionInWorld()`,
/// `vec3 NormalInWorld()` of unit length.
extern const char* const kVertexShaderInputs;

}  // namespace smile::camera::internal
