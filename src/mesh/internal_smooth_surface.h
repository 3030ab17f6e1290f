#pragma once

#include "mesh/triangle_mesh.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

/// The triangles with normals that make flat what is flat and round what is round: where triangles
/// meet at less than 30 degrees the light changes smoothly, elsewhere there is an edge.
TriangleMesh SmoothSurface(const scene::SurfaceMesh& surface);

}  // namespace smile::mesh
