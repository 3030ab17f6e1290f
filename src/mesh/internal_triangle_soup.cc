#include "mesh/internal_triangle_soup.h"

#include <cmath>
#include <utility>

#include "base/wording.h"

namespace smile::mesh {
namespace {

/// Greatest coordinate: its cube is still finite, and no real object is as large.
constexpr float kMaxCoordinate = 1e9f;

}  // namespace

/// Converts file axes to those of a mesh. Adding 0 turns negative zeros into zeros, so that equal
/// places have equal bits.
Eigen::Vector3f TriangleSoup::FromFileAxes(const Corner& corner) const {
  for (const float coordinate : corner) {
    if (std::abs(coordinate) <= kMaxCoordinate) continue;  // false for NaN
    throw BadMesh("found the coordinate " + NumberText(coordinate) + ", expected -1e9 to 1e9");
  }
  if (axes_ == MeshAxes::kAsWritten) {
    return {corner[0] + 0.0f, corner[1] + 0.0f, corner[2] + 0.0f};
  }
  return {corner[0] + 0.0f, -corner[2] + 0.0f, corner[1] + 0.0f};
}

void TriangleSoup::Add(const Corner& a, const Corner& b, const Corner& c) {
  if (++num_seen_ > limits_.max_triangles) {
    throw BadMesh("found more than " + std::to_string(limits_.max_triangles) +
                  " triangles, expected fewer");
  }
  const Eigen::Vector3f places[] = {FromFileAxes(a), FromFileAxes(b), FromFileAxes(c)};
  // Compared after conversion to floats and zeros without sign, as they are stored.
  if (places[0] == places[1] || places[1] == places[2] || places[2] == places[0]) return;
  // One statement each: the order fixes the numbers of the vertices.
  const std::uint32_t first = Weld(places[0]), second = Weld(places[1]), third = Weld(places[2]);
  mesh_.triangles.push_back({first, second, third});
}

std::uint32_t TriangleSoup::Weld(const Eigen::Vector3f& vertex) {
  const auto number = static_cast<std::uint32_t>(mesh_.vertices.size());
  const auto [entry, is_new] = numbers_.try_emplace({vertex.x(), vertex.y(), vertex.z()}, number);
  // Only equal places are merged: a tolerance could close gaps that are meant, and would depend on
  // the order.
  if (!is_new) return entry->second;
  if (mesh_.vertices.size() >= limits_.max_vertices) {
    throw BadMesh("found more than " + std::to_string(limits_.max_vertices) +
                  " vertices, expected fewer");
  }
  mesh_.vertices.push_back(vertex);
  return number;
}

scene::SurfaceMesh TriangleSoup::Take() {
  if (mesh_.triangles.empty()) {
    throw BadMesh(num_seen_ == 0 ? "found no triangles, expected at least one"
                                 : "found only triangles without area, expected a surface");
  }
  return std::move(mesh_);
}

}  // namespace smile::mesh
