#include "mesh/internal_smooth_surface.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

namespace smile::mesh {
namespace {

using Eigen::Vector3d;

/// As long as twice the triangle is large.
Vector3d AreaNormal(const scene::SurfaceMesh& surface, const scene::SurfaceMesh::Triangle& t) {
  const Vector3d a = surface.vertices[t[0]].cast<double>();
  const Vector3d b = surface.vertices[t[1]].cast<double>();
  const Vector3d c = surface.vertices[t[2]].cast<double>();
  return (b - a).cross(c - a);
}

}  // namespace

TriangleMesh SmoothSurface(const scene::SurfaceMesh& surface) {
  // The middle of a fan of thousands is flat enough, and each with each would take hours.
  constexpr std::size_t kMostSmoothed = 64;
  const double crease_cosine = std::cos(std::numbers::pi / 6);

  std::vector<Vector3d> normals;
  std::vector<std::vector<std::uint32_t>> around(surface.vertices.size());
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    normals.push_back(AreaNormal(surface, surface.triangles[i]));
    for (const std::uint32_t vertex : surface.triangles[i]) around[vertex].push_back(i);
  }
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    const Vector3d& own = normals[i];
    if (!(own.squaredNorm() > 0)) continue;  // a line: nothing to be seen
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const std::uint32_t vertex : surface.triangles[i]) {
      Vector3d normal = own;
      if (around[vertex].size() <= kMostSmoothed) {
        for (const std::uint32_t other : around[vertex]) {
          const double cosine = normals[other].dot(own);
          if (other != i && cosine > crease_cosine * normals[other].norm() * own.norm()) {
            normal += normals[other];
          }
        }
      }
      mesh.positions.push_back(surface.vertices[vertex]);
      mesh.normals.emplace_back(normal.normalized().cast<float>());
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace smile::mesh
