#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace smile::mesh {

/// A point of the lattice on which meshes are decomposed: integers from 0 to kLatticeSteps, so that
/// 64 bits suffice to decide exactly whether a point lies above a plane.
using LatticePoint = Eigen::Matrix<std::int64_t, 3, 1>;
inline constexpr std::int64_t kLatticeSteps = 1 << 20;

/// Returns the outward normal of a triangle, twice as long as its area: 41 bits and a sign per
/// component.
LatticePoint NormalOf(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);

/// Convex hull of lattice points, as triangles.
struct LatticeHull {
  std::vector<LatticePoint> corners;
  std::vector<Eigen::Vector3i> triangles;  ///< counter-clockwise seen from outside
  double volume = 0;                       ///< [steps3], above 0
};

/// Returns the convex hull by the quickhull algorithm, farthest point first, in exact arithmetic;
/// the result does not depend on the order of the points. Source: C. B. Barber, D. P. Dobkin, H.
/// Huhdanpaa, "The Quickhull Algorithm for Convex Hulls" (1996).
///
/// @param max_corners  stop at this number of corners, inside the true hull.
/// @param tolerance    leave out points at most this far outside [steps].
/// @returns nothing if all points lie in a plane, within `tolerance`.
std::optional<LatticeHull> HullOf(std::vector<LatticePoint> points, int max_corners,
                                  double tolerance);

/// Returns the faces of a hull as polygons of corner indices: triangles in one plane, within a few
/// steps, are merged.
std::vector<std::vector<std::uint32_t>> FacesOf(const LatticeHull& hull);

}  // namespace smile::mesh
