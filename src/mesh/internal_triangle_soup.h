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

/// Error in a mesh file; the message continues a sentence that begins with the file's name.
class BadMesh : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Collects the triangles of a file and merges equal vertices.
class TriangleSoup {
 public:
  using Corner = std::array<float, 3>;  ///< (X, Y, Z) of the file

  explicit TriangleSoup(const MeshLimits& limits, MeshAxes axes = MeshAxes::kStanding)
      : limits_(limits), axes_(axes) {}

  MeshAxes axes() const { return axes_; }

  /// Adds a triangle; drops it if two of its corners are equal.
  /// @throws BadMesh beyond the limits, or for a coordinate that is not finite or too large.
  void Add(const Corner& a, const Corner& b, const Corner& c);

  /// Returns the mesh.
  /// @throws BadMesh if it has no triangle.
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
