#include "model/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/overloaded.h"

namespace smile::model {
namespace {

constexpr int kRoundCorners = 16;

std::vector<Vector3> CornersOf(const scene::Block& block) {
  std::vector<Vector3> corners;
  for (double x : {-0.5, 0.5}) {
    for (double y : {-0.5, 0.5}) {
      for (double z : {-0.5, 0.5}) corners.push_back(block.size.cwiseProduct(Vector3(x, y, z)));
    }
  }
  return corners;
}

/// The rims of a cylinder (axis y) as polygons.
std::vector<Vector3> CornersOf(const scene::Cylinder& cylinder) {
  std::vector<Vector3> corners;
  for (int i = 0; i < kRoundCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRoundCorners;
    for (double end : {-0.5, 0.5}) {
      corners.emplace_back(cylinder.radius * std::cos(angle), end * cylinder.length,
                           cylinder.radius * std::sin(angle));
    }
  }
  return corners;
}

/// Returns the horizontal great circle of a sphere, in the frame of the solid.
std::vector<Vector3> CornersOf(const scene::Sphere& sphere, const Matrix3& R_SW) {
  std::vector<Vector3> corners;
  for (int i = 0; i < kRoundCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRoundCorners;
    corners.emplace_back(
        R_SW * Vector3(sphere.radius * std::cos(angle), sphere.radius * std::sin(angle), 0));
  }
  return corners;
}

double CrossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Appends one half of the hull of sorted points, without its last corner.
template <class Iterator>
void AppendHalfHull(Iterator begin, Iterator end, Outline* hull) {
  // Removes corners that do not turn left: each point is added and removed at most once.
  const std::size_t first = hull->size();
  for (Iterator point = begin; point != end; ++point) {
    while (hull->size() >= first + 2 &&
           CrossOf(hull->back() - hull->end()[-2], *point - hull->back()) <= 0) {
      hull->pop_back();
    }
    hull->push_back(*point);
  }
  // The last corner of each half is the first of the other, hence left out.
  hull->pop_back();
}

/// Returns the convex hull by monotone chains. Source: A. M. Andrew, "Another efficient algorithm
/// for convex hulls in two dimensions" (1979).
Outline HullOfPoints(Outline points) {
  std::ranges::sort(points, [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  if (points.size() < 3) return points;
  Outline hull;
  AppendHalfHull(points.begin(), points.end(), &hull);
  AppendHalfHull(points.rbegin(), points.rend(), &hull);
  return hull;
}

/// Returns how far `b` reaches inside the edges of `a`, at the edge where this is least: the
/// separating axis test over the normals of `a`.
double LeastReachOver(const Outline& a, const Outline& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d edge = a[(i + 1) % a.size()] - a[i];
    // A degenerate edge has no normal.
    if (edge.norm() < 1e-9) continue;
    const Eigen::Vector2d outwards = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
    // The reach of the farthest corner of `b` over this edge; negative if all of `b` is outside.
    double reach = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& corner : b) reach = std::max(reach, (a[i] - corner).dot(outwards));
    least = std::min(least, reach);
  }
  return least;
}

}  // namespace

Outline OutlineOf(const scene::SolidShape& shape, const RigidTransform& X_WS) {
  const std::vector<Vector3> corners =
      std::visit(Overloaded{[](const scene::Hull& hull) { return hull.polyhedron().corners; },
                            [&](const scene::Sphere& sphere) {
                              return CornersOf(sphere, X_WS.rotation().transpose());
                            },
                            [](const auto& simple) { return CornersOf(simple); }},
                 shape);
  Outline points;
  for (const Vector3& p_SQ : corners) points.emplace_back((X_WS * p_SQ).head<2>());
  return HullOfPoints(std::move(points));
}

double OverlapOf(const Outline& a, const Outline& b) {
  // A line or a point has no area to overlap with.
  if (a.size() < 3 || b.size() < 3) return 0;
  return std::min(LeastReachOver(a, b), LeastReachOver(b, a));
}

}  // namespace smile::model
