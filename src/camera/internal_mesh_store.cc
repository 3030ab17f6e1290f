#include "camera/internal_mesh_store.h"

#include <cstddef>

namespace smile::camera::internal {

const char* const kVertexShaderInputs = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row_x;
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
layout(location = 5) in vec3 screen_color;
layout(location = 6) in uint object_id;
layout(location = 7) in uint glows;

vec3 PositionInWorld() {
  vec4 p = vec4(position, 1.0);
  return vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
}

// The columns of the matrix are a rotation's, each stretched; a normal stretches the other way.
vec3 NormalInWorld() {
  mat3 stretched = transpose(mat3(row_x.xyz, row_y.xyz, row_z.xyz));
  vec3 stretch_squared = vec3(dot(stretched[0], stretched[0]), dot(stretched[1], stretched[1]),
                              dot(stretched[2], stretched[2]));
  return normalize(stretched * (normal / stretch_squared));
}
)";

namespace {

/// Vertex in the buffer of a mesh.
struct Corner {
  Eigen::Vector3f position, normal;
};

/// Returns an offset in a buffer as OpenGL expects it: a pointer, for historical reasons.
const void* Offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

/// Describes the attributes per vertex: position and normal.
void DescribeCorners() {
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), Offset(0));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), Offset(sizeof(float) * 3));
  for (const GLuint location : {0u, 1u}) glEnableVertexAttribArray(location);
}

/// Describes the attributes per instance (divisor 1): matrix rows, color, object id, glow.
void DescribeInstances() {
  for (GLuint row = 0; row < 3; ++row) {
    glVertexAttribPointer(2 + row, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                          Offset(offsetof(Instance, rows) + row * sizeof(float) * 4));
  }
  glVertexAttribPointer(5, 3, GL_FLOAT, GL_FALSE, sizeof(Instance),
                        Offset(offsetof(Instance, color)));
  glVertexAttribIPointer(6, 1, GL_UNSIGNED_INT, sizeof(Instance),
                         Offset(offsetof(Instance, object_id)));
  glVertexAttribIPointer(7, 1, GL_UNSIGNED_INT, sizeof(Instance),
                         Offset(offsetof(Instance, glows)));
  for (GLuint location = 2; location <= 7; ++location) {
    glEnableVertexAttribArray(location);
    glVertexAttribDivisor(location, 1);
  }
}

template <class T>
GLsizeiptr BytesOf(const std::vector<T>& values) {
  return static_cast<GLsizeiptr>(values.size() * sizeof(T));
}

}  // namespace

MeshStore::UploadedMesh MeshStore::Upload(const mesh::UnitMesh& unit_mesh) {
  // The vertex array remembers which buffers and layouts belong together, so drawing only binds it.
  const mesh::TriangleMesh mesh = mesh::MakeMesh(unit_mesh);
  UploadedMesh uploaded;
  std::vector<Corner> corners;
  for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
    corners.push_back({mesh.positions[k], mesh.normals[k]});
    uploaded.box.extend(mesh.positions[k]);
  }
  uploaded.num_indices = static_cast<GLsizei>(3 * mesh.triangles.size());
  glBindVertexArray(uploaded.vertex_array.name());
  glBindBuffer(GL_ARRAY_BUFFER, uploaded.corners.name());
  glBufferData(GL_ARRAY_BUFFER, BytesOf(corners), corners.data(), GL_STATIC_DRAW);
  DescribeCorners();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded.triangles.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, BytesOf(mesh.triangles), mesh.triangles.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, uploaded.instances.name());
  DescribeInstances();
  return uploaded;
}

MeshStore::UploadedMesh& MeshStore::MeshFor(const mesh::UnitMesh& unit_mesh) {
  const auto found = meshes_.find(unit_mesh);
  if (found != meshes_.end()) return found->second;
  // Removes each mesh that the present picture does not need; it is uploaded again when needed.
  if (meshes_.size() >= kMaxMeshes) {
    // Meshes with waiting instances are in use by the picture in progress.
    std::erase_if(meshes_, [](const auto& uploaded) { return uploaded.second.waiting.empty(); });
  }
  return meshes_.emplace(unit_mesh, Upload(unit_mesh)).first->second;
}

void MeshStore::Draw(const std::vector<Piece>& pieces, const Eigen::Matrix4f& clip_from_world) {
  for (const Piece& piece : pieces) {
    UploadedMesh& uploaded = MeshFor(piece.unit_mesh);
    if (MayShow(uploaded.box, piece.instance, clip_from_world)) {
      uploaded.waiting.push_back(piece.instance);
    }
  }
  // One call per unit mesh: instances are uploaded and drawn together.
  for (auto& [unit_mesh, uploaded] : meshes_) {
    if (uploaded.waiting.empty()) continue;
    glBindVertexArray(uploaded.vertex_array.name());
    glBindBuffer(GL_ARRAY_BUFFER, uploaded.instances.name());
    // New storage each time (GL_STREAM_DRAW): the card may still read that of the picture before.
    glBufferData(GL_ARRAY_BUFFER, BytesOf(uploaded.waiting), uploaded.waiting.data(),
                 GL_STREAM_DRAW);
    glDrawElementsInstanced(GL_TRIANGLES, uploaded.num_indices, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(uploaded.waiting.size()));
    uploaded.waiting.clear();
  }
}

}  // namespace smile::camera::internal
