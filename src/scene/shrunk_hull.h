#pragma once

#include <vector>

#include "scene/hull.h"

namespace smile::scene {

/// A convex polyhedron's corners with each face moved inwards by `margin` [m].
///
/// With the margin around it, its faces are where they were; edges and corners are rounded.
struct ShrunkHull {
  std::vector<Vector3> corners;
  double margin = 0;
};

/// Moves the faces inwards by at most `max_margin` [m]: halved until no edge vanishes.
ShrunkHull Shrink(const Polyhedron& polyhedron, double max_margin);

}  // namespace smile::scene
