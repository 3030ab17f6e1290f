#pragma once

#include <cstddef>
#include <vector>

#include "scene/custom_mesh.h"

namespace smile::mesh {

/// Limits of a convex decomposition.
struct PieceLimits {
  std::size_t max_triangles = 200'000;
  std::size_t max_pieces = 64;
  int max_corners = 128;  ///< per piece
};

/// Returns convex pieces that fill the solid bounded by a surface: its collision shape.
///
/// A convex solid is one piece, exactly unless it has more corners than a piece may have; in that
/// case, and for other solids, pieces are accurate to about 1 % of the solid's size. Holes and
/// hollows stay open: the solid is cut by planes across the axes until the pieces have little
/// excess volume, or their number reaches the limit. A surface that is not closed has no inside:
/// its piece is the hull of its vertices. Triangles may face outwards or inwards, as long as all of
/// them agree.
///
/// Deterministic: the same mesh gives the same bits. Method and measurements:
/// docs/decisions/meshes.md.
///
/// @throws std::invalid_argument if there are too many triangles, or all of them lie in a plane.
std::vector<scene::Hull> ConvexPieces(const scene::SurfaceMesh& mesh,
                                      const PieceLimits& limits = {});

}  // namespace smile::mesh
