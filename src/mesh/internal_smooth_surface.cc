#include "mesh/internal_smooth_surface.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

namespace smile::mesh {
namespace {

using Eigen::Vector3d;

/// Returns the normal of a triangle, twice as long as its area, so that sums of normals are
/// weighted by area.
Vector3d AreaNormal(const scene::SurfaceMesh& surface, const scene::SurfaceMesh::Triangle& t) {
  const Vector3d a = surface.vertices[t[0]].cast<double>();
  const Vector3d b = surface.vertices[t[1]].cast<double>();
  const Vector3d c = surface.vertices[t[2]].cast<double>();
  return (b - a).cross(c - a);
}

/// Merges corners at a vertex that have the same normal, so that a graphics card processes them
/// once.
class SharedCorners {
 public:
  explicit SharedCorners(std::size_t num_vertices) : at_(num_vertices) {}

  std::uint32_t IndexOf(std::uint32_t vertex, const Eigen::Vector3f& position,
                        const Eigen::Vector3f& normal, TriangleMesh* mesh) {
    std::vector<std::uint32_t>& known = at_[vertex];
    // The center of a fan may have thousands of corners: compare with the latest only.
    constexpr std::size_t kLatest = 8;
    const std::size_t first = known.size() > kLatest ? known.size() - kLatest : 0;
    for (std::size_t k = first; k < known.size(); ++k) {
      if (mesh->normals[known[k]] == normal) return known[k];
    }
    known.push_back(static_cast<std::uint32_t>(mesh->positions.size()));
    mesh->positions.push_back(position);
    mesh->normals.push_back(normal);
    return known.back();
  }

 private:
  std::vector<std::vector<std::uint32_t>> at_;  ///< of each vertex
};

}  // namespace

TriangleMesh SmoothSurface(const scene::SurfaceMesh& surface) {
  // Upper bound of triangles at a smoothed vertex, since cost is quadratic in it. The center of a
  // larger fan is shaded flat.
  constexpr std::size_t kMostSmoothed = 64;
  const double crease_cosine = std::cos(std::numbers::pi / 6);

  std::vector<Vector3d> normals;
  std::vector<std::vector<std::uint32_t>> around(surface.vertices.size());
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    normals.push_back(AreaNormal(surface, surface.triangles[i]));
    for (const std::uint32_t vertex : surface.triangles[i]) around[vertex].push_back(i);
  }
  TriangleMesh mesh;
  SharedCorners corners(surface.vertices.size());
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    const Vector3d& own = normals[i];
    if (!(own.squaredNorm() > 0)) continue;  // degenerate: invisible
    scene::SurfaceMesh::Triangle triangle{};
    for (std::size_t k = 0; k < triangle.size(); ++k) {
      const std::uint32_t vertex = surface.triangles[i][k];
      const bool is_smoothed = around[vertex].size() <= kMostSmoothed;
      Vector3d normal = is_smoothed ? Vector3d::Zero() : own;
      if (is_smoothed) {
        // Always in the same order: triangles with the same neighbors then get the same bits, and
        // share the corner.
        for (const std::uint32_t other : around[vertex]) {
          const double cosine = normals[other].dot(own);
          // Average the normals that differ from this triangle's by less than the crease angle.
          if (other == i || cosine > crease_cosine * normals[other].norm() * own.norm()) {
            normal += normals[other];
          }
        }
      }
      triangle[k] = corners.IndexOf(vertex, surface.vertices[vertex],
                                    normal.normalized().cast<float>(), &mesh);
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace smile::mesh
