#pragma once

#include <vector>

#include "scene/hull.h"

namespace smile::scene {

/// Corners of a convex polyhedron with each face moved inwards by `margin` [m].
///
/// With the margin around it, the faces are those of the original; edges and corners are rounded.
struct ShrunkHull {
  std::vector<Vector3> corners;
  double margin = 0;
};

/// Moves the faces inwards by at most `max_margin` [m], halved until no edge vanishes.
ShrunkHull Shrink(const Polyhedron& polyhedron, double max_margin);

}  // namespace smile::scene
