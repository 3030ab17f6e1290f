#pragma once

#include "mesh/triangle_mesh.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

/// Returns the triangles with smooth normals: where triangles meet at less than 30 degrees the
/// shading changes smoothly, elsewhere there is a sharp edge.
TriangleMesh SmoothSurface(const scene::SurfaceMesh& surface);

}  // namespace smile::mesh
