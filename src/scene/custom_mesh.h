#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "scene/hull.h"

namespace smile::scene {

/// Triangle surface. Positions have the precision of mesh files.
struct SurfaceMesh {
  using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise seen from outside

  std::vector<Eigen::Vector3f> vertices;
  std::vector<Triangle> triangles;

  bool operator==(const SurfaceMesh&) const = default;
};

/// Content of a mesh file in a scene: triangles to draw and convex pieces to collide. Both in units
/// of the file, with axes converted to those of scenes: the file's (X, Y, Z) is (X, -Z, Y).
struct CustomMesh {
  SurfaceMesh surface;
  std::vector<Hull> pieces;  ///< at least one; without parts that are only visible

  bool operator==(const CustomMesh&) const = default;
};

}  // namespace smile::scene
