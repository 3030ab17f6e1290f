#pragma once

#include <cstddef>
#include <vector>

#include "scene/hull.h"
#include "scene/shape.h"

namespace smile::scene {

Hull HullOf(const Frustum& frustum);

/// Segment of a ring R, in its own frame P, which is turned about the ring's axis.
struct RingPiece {
  Hull hull;
  RigidTransform X_RP;
};

/// Returns convex pieces that fill a ring; pieces of the same form share one hull.
std::vector<RingPiece> PiecesOf(const Ring& ring);
std::size_t NumPiecesOf(const Ring& ring);

}  // namespace smile::scene
