#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/mesh_options.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

/// What is wrong with a mesh file, in words that follow its name.
class BadMesh : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Collects the triangles of a file, corner by corner as the file has them.
class TriangleSoup {
 public:
  using Corner = std::array<float, 3>;  ///< (X, Y, Z) of the file

  explicit TriangleSoup(const MeshLimits& limits, MeshAxes axes = MeshAxes::kStanding)
      : limits_(limits), axes_(axes) {}

  MeshAxes axes() const { return axes_; }

  /// @throws BadMesh beyond the limits, or for a coordinate that is no number or beyond all bounds.
  void Add(const Corner& a, const Corner& b, const Corner& c);

  /// @throws BadMesh if there is no triangle.
  scene::SurfaceMesh Take();

 private:
  Eigen::Vector3f FromFileAxes(const Corner& corner) const;
  std::uint32_t Weld(const Eigen::Vector3f& vertex);

  MeshLimits limits_;
  MeshAxes axes_;
  std::size_t num_seen_ = 0;
  scene::SurfaceMesh mesh_;
  std::map<std::array<float, 3>, std::uint32_t> numbers_;
};

}  // namespace smile::mesh
