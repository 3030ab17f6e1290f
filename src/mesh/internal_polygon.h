#pragma once

#include <vector>

#include "mesh/modeling.h"

namespace smile::mesh::internal {

/// A flat section cut into triangles that run as it does. Concave ones too, as long as no side
/// crosses another.
std::vector<scene::SurfaceMesh::Triangle> Triangulated(const Section& section);

/// The outline with every side moved inwards by `distance`; as many corners. Only for distances
/// smaller than the radii of its curves and half of its width.
Outline Inset(const Outline& outline, double distance);

}  // namespace smile::mesh::internal
