#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "scene/hull.h"

namespace smile::scene {

/// A surface of triangles. Positions have the precision mesh files have.
struct SurfaceMesh {
  using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise seen from outside

  std::vector<Eigen::Vector3f> vertices;
  std::vector<Triangle> triangles;

  bool operator==(const SurfaceMesh&) const = default;
};

/// What a mesh file is in a scene: its triangles to be seen, and convex pieces to be felt. Both in
/// units of the file, its axes turned as scenes have them: the file's (X, Y, Z) is (X, -Z, Y).
struct CustomMesh {
  SurfaceMesh surface;
  std::vector<Hull> pieces;  ///< at least one, unless it is only ever drawn

  bool operator==(const CustomMesh&) const = default;
};

}  // namespace smile::scene
