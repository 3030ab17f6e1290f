#include "mesh/internal_polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace smile::mesh::internal {
namespace {

using Eigen::Vector2d;
using Triangle = scene::SurfaceMesh::Triangle;

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns twice the area of a triangle, positive if it runs counter-clockwise.
double TurnAt(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return Cross(b - a, c - b);
}

/// Returns the section in its own plane, where it runs counter-clockwise.
Outline Flattened(const Section& section) {
  Vector3 normal = Vector3::Zero();  // Newell's method
  for (std::size_t i = 0; i < section.size(); ++i) {
    normal += section[i].cross(section[(i + 1) % section.size()]);
  }
  // Any two perpendicular axes of the plane; right-handed with the normal, so the direction of
  // rotation stays.
  const Vector3 x = normal.unitOrthogonal(), y = normal.normalized().cross(x);
  Outline outline;
  for (const Vector3& p : section) outline.emplace_back(x.dot(p), y.dot(p));
  return outline;
}

/// Returns true if the corner `at` of the remaining polygon is convex and no other corner lies in
/// its triangle.
bool IsEar(const Outline& outline, const std::vector<std::uint32_t>& rest, std::size_t at) {
  const std::size_t n = rest.size();
  const Vector2d &a = outline[rest[(at + n - 1) % n]], &b = outline[rest[at]],
                 &c = outline[rest[(at + 1) % n]];
  if (!(TurnAt(a, b, c) > 0)) return false;
  return std::none_of(rest.begin(), rest.end(), [&](std::uint32_t k) {
    const Vector2d& p = outline[k];
    // Compared by place: an outline may visit a point twice.
    if (p == a || p == b || p == c) return false;
    return TurnAt(a, b, p) >= 0 && TurnAt(b, c, p) >= 0 && TurnAt(c, a, p) >= 0;
  });
}

/// Returns the ear with the shortest cut: slim triangles are shaded badly.
std::size_t BestEar(const Outline& outline, const std::vector<std::uint32_t>& rest) {
  const std::size_t n = rest.size();
  // Falls back to corner 0 if rounding leaves no ear, so that the loop always ends.
  std::size_t best = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const double cut = (outline[rest[(i + n - 1) % n]] - outline[rest[(i + 1) % n]]).norm();
    if (cut >= shortest || !IsEar(outline, rest, i)) continue;
    best = i;
    shortest = cut;
  }
  return best;
}

}  // namespace

std::vector<Triangle> Triangulated(const Section& section) {
  // Ear clipping: each simple polygon has an ear, so the loop removes one corner per round.
  const Outline outline = Flattened(section);
  std::vector<std::uint32_t> rest(section.size());
  std::iota(rest.begin(), rest.end(), 0u);
  std::vector<Triangle> triangles;
  while (rest.size() > 2) {
    const std::size_t n = rest.size(), ear = BestEar(outline, rest);
    triangles.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

Outline Inset(const Outline& outline, double distance) {
  Outline inset;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d before = (outline[i] - outline[(i + n - 1) % n]).normalized();
    const Vector2d after = (outline[(i + 1) % n] - outline[i]).normalized();
    // Along the bisector, far enough to be `distance` from both sides; bounded at sharp tips.
    const Vector2d inwards(-(before + after).y(), (before + after).x());
    // The sum of both directions has the length 2 cos(half of the turn); a miter needs distance /
    // cos, hence the division by half of its square.
    const double share = std::max(0.5, inwards.squaredNorm() / 2);
    inset.emplace_back(outline[i] + distance * inwards / share);
  }
  return inset;
}

}  // namespace smile::mesh::internal
