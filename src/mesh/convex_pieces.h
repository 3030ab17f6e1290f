#pragma once

#include <cstddef>
#include <vector>

#include "scene/custom_mesh.h"

namespace smile::mesh {

/// What a decomposition may cost.
struct PieceLimits {
  std::size_t max_triangles = 200'000;
  std::size_t max_pieces = 64;
  int max_corners = 128;  ///< of a piece
};

/// Convex pieces that fill the solid a surface bounds: what physics feels of it.
///
/// A convex solid is one piece, exactly unless it has more corners than a piece may have; then, and
/// for other solids, pieces are true within about 1 % of the solid's size. Holes and hollows stay
/// open: the solid is cut by planes across the axes until what the pieces fill too much is small,
/// or they are as many as allowed. A surface that is not closed has no inside: it is felt as the
/// hull of its vertices. Which side of the triangles is outside does not matter, as long as they
/// agree.
///
/// Same mesh, same bits. How it works, and what was measured: docs/decisions/meshes.md.
///
/// @throws std::invalid_argument when there are too many triangles, or all of them lie in a plane.
std::vector<scene::Hull> ConvexPieces(const scene::SurfaceMesh& mesh,
                                      const PieceLimits& limits = {});

}  // namespace smile::mesh
