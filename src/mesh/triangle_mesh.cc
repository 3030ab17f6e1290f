#include "mesh/triangle_mesh.h"

#include <stdexcept>

namespace smile::mesh {

TriangleMesh Scaled(TriangleMesh mesh, const Eigen::Vector3f& factors) {
  if (!(factors.minCoeff() > 0)) {
    throw std::invalid_argument("a mesh is scaled by " + std::to_string(factors.minCoeff()) +
                                ", expected factors above 0");
  }
  for (Eigen::Vector3f& position : mesh.positions) position = position.cwiseProduct(factors);
  // Normals transform by the inverse transpose, here the reciprocal factors.
  for (Eigen::Vector3f& normal : mesh.normals) {
    normal = normal.cwiseQuotient(factors).normalized();
  }
  return mesh;
}

}  // namespace smile::mesh
