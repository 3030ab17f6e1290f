#pragma once

#include <vector>

#include "mesh/modeling.h"

namespace smile::mesh::internal {

/// Returns the triangles of a flat section, in its direction of rotation. The section may be
/// concave if no two sides cross.
std::vector<scene::SurfaceMesh::Triangle> Triangulated(const Section& section);

/// Returns the outline with each side moved inwards by `distance`; it has as many corners. Only for
/// distances below the radii of its curves and half of its width.
Outline Inset(const Outline& outline, double distance);

}  // namespace smile::mesh::internal
