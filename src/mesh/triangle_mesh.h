#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace smile::mesh {

/// Triangles that bound a solid, as a graphics card likes them.
///
/// Seen from outside, a triangle's corners run counter-clockwise. Corners that share a place but
/// not a normal (the edges of a block) are stored once for each normal.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> positions;               ///< corners [m]
  std::vector<Eigen::Vector3f> normals;                 ///< unit length, one per corner
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of corners

  bool operator==(const TriangleMesh&) const = default;
};

/// Returns the mesh scaled by a positive factor along each axis; normals stay normal to their
/// surface.
TriangleMesh Scaled(TriangleMesh mesh, const Eigen::Vector3f& factors);

}  // namespace smile::mesh
