#include "scene/internal_prisms.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace smile::scene {
namespace {

/// Limit of pieces per ring, since physics tests each pair of pieces. A ring with more sides has
/// several sides per piece, and the hole is still round within half a percent.
constexpr int kMaxRingPieces = 64;

using Polygon = std::vector<Vector3>;

double AngleOf(int corner, int sides) { return 2 * std::numbers::pi * corner / sides; }

Vector3 CornerAt(double radius, int corner, int sides) {
  const double angle = AngleOf(corner, sides);
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

/// Returns the corners of a regular polygon; only its center if the radius is 0.
Polygon RegularPolygon(double radius, int sides) {
  if (radius == 0) return {Vector3::Zero()};
  Polygon polygon;
  for (int k = 0; k < sides; ++k) polygon.push_back(CornerAt(radius, k, sides));
  return polygon;
}

/// Returns the hull of two polygons at z = -height / 2 and +height / 2, counter-clockwise seen from
/// +z. One of them may be a single point; otherwise they have the same number of corners.
Hull HullBetween(const Polygon& low, const Polygon& high, double height) {
  Polyhedron polyhedron;
  for (const Vector3& p : low) polyhedron.corners.push_back(p - Vector3(0, 0, height / 2));
  for (const Vector3& p : high) polyhedron.corners.push_back(p + Vector3(0, 0, height / 2));

  const auto num_low = static_cast<std::uint32_t>(low.size());
  const auto num_high = static_cast<std::uint32_t>(high.size());
  const std::uint32_t sides = std::max(num_low, num_high);
  // The modulo maps all corners of a single point to it, so that both cases share the loop.
  const auto low_corner = [&](std::uint32_t k) { return k % num_low; };
  const auto high_corner = [&](std::uint32_t k) { return num_low + k % num_high; };

  Polyhedron::Face floor, lid;
  for (std::uint32_t k = 0; k < sides; ++k) {
    // The floor is traversed backwards, so that it is counter-clockwise seen from below.
    floor.push_back(low_corner(sides - 1 - k));
    lid.push_back(high_corner(k));
    Polyhedron::Face side{low_corner(k)};
    if (num_low > 1) side.push_back(low_corner(k + 1));
    side.push_back(high_corner(k + 1));
    if (num_high > 1) side.push_back(high_corner(k));
    polyhedron.faces.push_back(side);
  }
  if (num_low > 1) polyhedron.faces.push_back(floor);
  if (num_high > 1) polyhedron.faces.push_back(lid);
  return Hull(std::move(polyhedron));
}

/// Returns the piece from corner 0 to corner `num_sides` of the ring.
Hull RingSegment(const Ring& ring, int num_sides) {
  Polygon polygon;
  for (int k = 0; k <= num_sides; ++k) {
    polygon.push_back(CornerAt(ring.radius_outer, k, ring.sides));
  }
  polygon.push_back(CornerAt(ring.radius_inner, num_sides, ring.sides));
  polygon.push_back(CornerAt(ring.radius_inner, 0, ring.sides));
  return HullBetween(polygon, polygon, ring.height);
}

RigidTransform TurnedAboutZ(double angle) {
  return RigidTransform(Matrix3(Eigen::AngleAxisd(angle, Vector3::UnitZ())), Vector3::Zero());
}

}  // namespace

Hull HullOf(const Frustum& frustum) {
  return HullBetween(RegularPolygon(frustum.radius_bottom, frustum.sides),
                     RegularPolygon(frustum.radius_top, frustum.sides), frustum.height);
}

std::size_t NumPiecesOf(const Ring& ring) {
  return ring.radius_inner == 0 ? 1 : std::min(ring.sides, kMaxRingPieces);
}

std::vector<RingPiece> PiecesOf(const Ring& ring) {
  if (ring.radius_inner == 0) {
    const Polygon disc = RegularPolygon(ring.radius_outer, ring.sides);
    return {{HullBetween(disc, disc, ring.height), RigidTransform()}};
  }
  std::vector<RingPiece> pieces;
  // Pieces of equal size share one hull, which physics and pictures then process once.
  std::map<int, Hull> segments;  // by their number of sides; it has two values at most
  const auto num_pieces = static_cast<int>(NumPiecesOf(ring));
  for (int i = 0; i < num_pieces; ++i) {
    // Integer arithmetic distributes the sides evenly and without gaps.
    const int begin = i * ring.sides / num_pieces, end = (i + 1) * ring.sides / num_pieces;
    Hull& segment = segments[end - begin];
    if (segment == Hull()) segment = RingSegment(ring, end - begin);
    pieces.push_back({segment, TurnedAboutZ(AngleOf(begin, ring.sides))});
  }
  return pieces;
}

}  // namespace smile::scene
