#include "scene/shrunk_hull.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cstdint>
#include <utility>

// Shrinks a hull by a margin, for collision shapes that the physics library inflates by the same
// margin again: the outer faces are then where the scene has them. Corners move, and faces keep
// their directions.

namespace smile::scene {
namespace {

/// Returns the displacement of each corner when the faces around it move inwards by 1: x with
/// normal . x = -1 for each of their normals. Where more than three faces meet there may be no such
/// x; the least-squares solution is then lengthened until all faces have moved far enough.
std::vector<Vector3> InwardMoves(const Polyhedron& polyhedron) {
  std::vector<std::vector<Vector3>> normals(polyhedron.corners.size());
  for (const Polyhedron::Face& face : polyhedron.faces) {
    const Vector3 normal = polyhedron.AreaVectorOf(face).normalized();
    for (const std::uint32_t corner : face) normals[corner].push_back(normal);
  }
  std::vector<Vector3> moves;
  for (const std::vector<Vector3>& around : normals) {
    Matrix3 squares = Matrix3::Zero();
    Vector3 sum = Vector3::Zero();
    for (const Vector3& normal : around) {
      squares += normal * normal.transpose();
      sum += normal;
    }
    // Normal equations of the least-squares problem normal . x = 1.
    const Vector3 outwards = squares.ldlt().solve(sum);
    constexpr double kTiny = 1e-9;  // if no direction leads inwards
    double least = 1;
    for (const Vector3& normal : around) least = std::min(least, normal.dot(outwards));
    moves.push_back(-outwards / std::max(least, kTiny));
  }
  return moves;
}

std::vector<Vector3> Moved(std::vector<Vector3> corners, const std::vector<Vector3>& moves,
                           double distance) {
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] += distance * moves[i];
  return corners;
}

/// True if every edge keeps its direction: then the moved faces still meet in the moved corners. An
/// edge that reverses has vanished.
bool KeepsItsEdges(const Polyhedron& polyhedron, const std::vector<Vector3>& moved) {
  for (const Polyhedron::Face& face : polyhedron.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t from = face[k], to = face[(k + 1) % face.size()];
      const Vector3 edge = polyhedron.corners[to] - polyhedron.corners[from];
      if (!(edge.dot(moved[to] - moved[from]) > 0)) return false;
    }
  }
  return true;
}

}  // namespace

ShrunkHull Shrink(const Polyhedron& polyhedron, double max_margin) {
  constexpr double kLeastMargin = 1e-7;
  const std::vector<Vector3> moves = InwardMoves(polyhedron);
  // Halving the margin finds one within a factor of two of the largest possible.
  for (double margin = max_margin; margin > kLeastMargin; margin /= 2) {
    std::vector<Vector3> corners = Moved(polyhedron.corners, moves, margin);
    if (KeepsItsEdges(polyhedron, corners)) return {std::move(corners), margin};
  }
  return {polyhedron.corners, 0};
}

}  // namespace smile::scene
