#include "page/page_meshes.h"

#include "base/bytes.h"

// Meshes are transferred once per scene and scaled by the page: many visuals share one unit mesh.

namespace smile::page {
namespace {

/// Returns true for shapes that a page makes from their sizes, so that no mesh is transferred.
bool IsDrawnByPages(const scene::VisualShape& shape) {
  return !std::holds_alternative<scene::Hull>(shape) &&
         !std::holds_alternative<scene::DrawnMesh>(shape);
}

void Append(const std::vector<Eigen::Vector3f>& points, ByteWriter* writer) {
  for (const Eigen::Vector3f& point : points) {
    for (const float number : point) writer->Put(number);
  }
}

}  // namespace

PageMeshes::PageMeshes(const scene::VisualModel& model) {
  for (const scene::Visual& visual : model.visuals) {
    if (IsDrawnByPages(visual.shape)) continue;
    const mesh::UnitMesh unit_mesh = mesh::UnitMeshOf(visual.shape);
    // Equal meshes of several visuals are transferred once; visuals differ in scale only.
    if (number_of_.emplace(unit_mesh, meshes_.size()).second) meshes_.push_back(unit_mesh);
  }
}

std::optional<std::size_t> PageMeshes::NumberOf(const scene::VisualShape& shape) const {
  if (IsDrawnByPages(shape)) return std::nullopt;
  const auto found = number_of_.find(mesh::UnitMeshOf(shape));
  return found == number_of_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> PageMeshes::Bytes(std::size_t mesh) const {
  if (mesh >= meshes_.size()) return std::nullopt;
  return BytesOf(mesh::MakeMesh(meshes_[mesh]));
}

// Numbers of vertices and triangles, then positions, normals and triangles, all of 32 bits. Pages
// view them as typed arrays without a copy.
std::string BytesOf(const mesh::TriangleMesh& mesh) {
  ByteWriter writer;
  writer.Put(static_cast<std::uint32_t>(mesh.positions.size()));
  writer.Put(static_cast<std::uint32_t>(mesh.triangles.size()));
  Append(mesh.positions, &writer);
  Append(mesh.normals, &writer);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) writer.Put(corner);
  }
  const std::span<const std::byte> bytes = writer.bytes();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace smile::page
