#pragma once

#include <vector>

#include "scene/hull.h"

namespace smile::physics {

/// A hull's corners with each face moved inwards by `margin` [m], which Bullet puts on again.
///
/// Faces end up where they were; edges and corners become round. The margin is half a millimetre,
/// or as much less as it takes that no edge vanishes.
struct ShrunkHull {
  std::vector<Vector3> corners;
  double margin = 0;
};
ShrunkHull Shrink(const scene::Polyhedron& polyhedron);

}  // namespace smile::physics
