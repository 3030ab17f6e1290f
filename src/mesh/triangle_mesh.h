#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace smile::mesh {

/// Triangles that bound a solid, in the layout of a graphics card.
///
/// Seen from outside, a triangle's corners run counter-clockwise. Corners at the same place with
/// different normals (edges of a block) are stored once per normal.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> positions;               ///< corners [m]
  std::vector<Eigen::Vector3f> normals;                 ///< unit length, one per corner
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of corners

  bool operator==(const TriangleMesh&) const = default;
};

/// Returns the mesh scaled by a positive factor along each axis; normals stay perpendicular to
/// their surface.
/// @throws std::invalid_argument unless all factors are positive.
TriangleMesh Scaled(TriangleMesh mesh, const Eigen::Vector3f& factors);

}  // namespace smile::mesh
