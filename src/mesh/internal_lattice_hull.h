#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace smile::mesh {

/// A point of the lattice on which meshes are taken apart: whole numbers from 0 to kLatticeSteps,
/// so that whether a point lies above a plane is known exactly, in 64 bits.
using LatticePoint = Eigen::Matrix<std::int64_t, 3, 1>;
inline constexpr std::int64_t kLatticeSteps = 1 << 20;

/// Outwards, twice as long as the triangle is large: 41 bits and a sign for each number.
LatticePoint NormalOf(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);

/// The convex hull of lattice points, as triangles.
struct LatticeHull {
  std::vector<LatticePoint> corners;
  std::vector<Eigen::Vector3i> triangles;  ///< counter-clockwise seen from outside
  double volume = 0;                       ///< [steps3], above 0
};

/// By the quickhull algorithm, the farthest point first, in exact arithmetic; the answer does not
/// depend on the order of the points.
/// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull Algorithm for Convex Hulls"
/// (1996).
///
/// @param max_corners  then it stops, inside the true hull.
/// @param tolerance    points so near outside are left out [steps].
/// @returns nothing when all points lie in a plane, within `tolerance`.
std::optional<LatticeHull> HullOf(std::vector<LatticePoint> points, int max_corners,
                                  double tolerance);

/// The faces of a hull: triangles that lie in one plane, within a few steps, become one polygon.
std::vector<std::vector<std::uint32_t>> FacesOf(const LatticeHull& hull);

}  // namespace smile::mesh
