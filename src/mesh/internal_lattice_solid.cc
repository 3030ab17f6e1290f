// The solid as a signed sum over triangles: each bounds a column down to a floor, positive where
// the surface faces up. Volumes of boxes need neither cuts through the solid nor a topology, so
// meshes with shared edges or several bodies work like any other. The lattice maps the longest side
// to kLatticeSteps steps.

#include "mesh/internal_lattice_solid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace smile::mesh {
namespace {

using Point = Eigen::Vector3d;

/// Convex polygon with room for a triangle clipped by six planes.
class Polygon {
 public:
  // Doubles hold lattice coordinates exactly; only points on cutting planes are rounded.
  explicit Polygon(const LatticeSolid::Triangle& triangle) : size_(3) {
    for (int i = 0; i < 3; ++i) points_[i] = triangle[i].cast<double>();
  }

  /// Keeps the part with side * p[axis] >= side * place (Sutherland-Hodgman clipping against one
  /// plane).
  void Cut(int axis, double place, double side) {
    std::array<Point, kMax> kept;
    int count = 0;
    for (int i = 0; i < size_; ++i) {
      const Point &a = points_[i], &b = points_[(i + 1) % size_];
      const double above_a = side * (a[axis] - place), above_b = side * (b[axis] - place);
      // Points on the plane belong to either part.
      if (above_a >= 0 && count < kMax) kept[count++] = a;
      if ((above_a > 0 && above_b < 0) || (above_a < 0 && above_b > 0)) {
        if (count == kMax) break;
        // Interpolate from the same end in both triangles of an edge, so that they get the same
        // bits.
        const bool is_forward = above_a < above_b;
        const Point& from = is_forward ? a : b;
        const Point& to = is_forward ? b : a;
        const double low = is_forward ? above_a : above_b, high = is_forward ? above_b : above_a;
        kept[count] = from + (to - from) * (low / (low - high));
        // The coordinate across the plane is set, not computed, so that both halves meet exactly.
        kept[count++][axis] = place;
      }
    }
    points_ = kept;
    size_ = count;
  }

  /// Clips at the planes of a box across the first `num_axes` axes.
  /// @param bounds  of the polygon: planes beside it need no cut.
  void CutToBox(const LatticeBox& box, const LatticeBox& bounds, int num_axes) {
    for (int axis = 0; axis < num_axes && size_ > 0; ++axis) {
      if (bounds.low[axis] <= box.low[axis]) Cut(axis, static_cast<double>(box.low[axis]), 1);
      if (bounds.high[axis] >= box.high[axis]) Cut(axis, static_cast<double>(box.high[axis]), -1);
    }
  }

  /// Returns the volume between the polygon and the plane z = floor; negative if the polygon faces
  /// down.
  double VolumeAbove(double floor) const {
    double volume = 0;
    for (int i = 2; i < size_; ++i) {
      const Point &a = points_[0], &b = points_[i - 1], &c = points_[i];
      const double area =
          ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x())) / 2;
      volume += area * ((a.z() + b.z() + c.z()) / 3 - floor);
    }
    return volume;
  }

  const Point* begin() const { return points_.data(); }
  const Point* end() const { return points_.data() + size_; }

 private:
  // A triangle gains at most one corner per plane: 9 after six planes.
  static constexpr int kMax = 12;
  std::array<Point, kMax> points_;
  int size_;
};

/// Returns the signed volume of a surface (divergence theorem), and whether it is closed.
double MeasureClosed(const std::vector<LatticeSolid::Triangle>& triangles, bool* is_closed) {
  using Edge = std::array<std::int64_t, 6>;
  std::vector<std::pair<Edge, int>> edges;
  edges.reserve(3 * triangles.size());
  double volume = 0;
  for (const LatticeSolid::Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) {
      const LatticePoint &a = triangle[i], &b = triangle[(i + 1) % 3];
      // Count each edge once per direction: +1 one way, -1 the other. By coordinates instead of
      // indices: vertices that fell on the same lattice point are the same.
      const Edge forth{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
      const Edge back{b.x(), b.y(), b.z(), a.x(), a.y(), a.z()};
      edges.emplace_back(std::min(forth, back), forth < back ? 1 : -1);
    }
    const auto corner = [&](int i) { return Point(triangle[i].cast<double>()); };
    volume += corner(0).cross(corner(1)).dot(corner(2)) / 6;
  }
  std::sort(edges.begin(), edges.end());
  // Closed if the directions of each edge cancel out. This also accepts solids that share an edge.
  *is_closed = true;
  int balance = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    balance += edges[i].second;
    if (i + 1 < edges.size() && edges[i + 1].first == edges[i].first) continue;
    if (balance != 0) *is_closed = false;
    balance = 0;
  }
  return volume;
}

}  // namespace

LatticePoint CornerOf(const LatticeBox& box, int corner) {
  LatticePoint point;
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = corner >> axis & 1 ? box.high[axis] : box.low[axis];
  }
  return point;
}

LatticeSolid::LatticeSolid(const scene::SurfaceMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex.cast<double>());
  origin_ = box.min();
  // The longest side spans the whole lattice.
  step_ = box.sizes().maxCoeff() / static_cast<double>(kLatticeSteps);
  // All vertices in one place; the triangles are dropped as degenerate.
  if (!(step_ > 0)) step_ = 1;
  std::vector<LatticePoint> vertices;
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    LatticePoint& point = vertices.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      const double place = static_cast<double>(vertex[axis]);
      point[axis] =
          std::clamp<std::int64_t>(std::llround((place - origin_[axis]) / step_), 0, kLatticeSteps);
      // Remember the exact coordinates, for PlaceOf().
      known_places_[axis].try_emplace(point[axis], place);
    }
  }
  std::vector<Triangle> triangles;
  for (const scene::SurfaceMesh::Triangle& t : mesh.triangles) {
    triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
  }
  SetTriangles(std::move(triangles));
}

/// Takes triangles without degenerate ones, facing outwards, and measures them.
void LatticeSolid::SetTriangles(std::vector<Triangle> triangles) {
  std::erase_if(triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  triangles_ = std::move(triangles);
  volume_ = MeasureClosed(triangles_, &is_closed_);
  // The file's triangles face inwards: reverse all.
  if (volume_ < 0) {
    volume_ = -volume_;
    for (Triangle& triangle : triangles_) std::swap(triangle[1], triangle[2]);
  }
  triangle_bounds_.clear();
  bounds_ = {LatticePoint::Constant(kLatticeSteps), LatticePoint::Zero()};
  for (const Triangle& t : triangles_) {
    const LatticeBox bounds{t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
    triangle_bounds_.push_back(bounds);
    bounds_.low = bounds_.low.cwiseMin(bounds.low);
    bounds_.high = bounds_.high.cwiseMax(bounds.high);
  }
}

LatticeSolid LatticeSolid::Simplified(std::size_t max_triangles) const {
  LatticeSolid simple = *this;
  constexpr std::int64_t kFinest = kLatticeSteps / 1024, kCoarsest = kLatticeSteps / 64;
  for (std::int64_t size = kFinest; size <= kCoarsest && simple.triangles_.size() > max_triangles;
       size *= 2) {
    // Vertex clustering: the first vertex in each cube of the lattice replaces all others in it.
    // Replacing corners consistently keeps the surface closed.
    std::map<std::array<std::int64_t, 3>, LatticePoint> chosen;
    std::vector<Triangle> triangles = triangles_;
    for (Triangle& triangle : triangles) {
      for (LatticePoint& corner : triangle) {
        const LatticePoint cube = corner / size;
        corner = chosen.try_emplace({cube.x(), cube.y(), cube.z()}, corner).first->second;
      }
    }
    // Each round starts from the full mesh, so that errors of merging do not add up.
    simple.SetTriangles(std::move(triangles));
  }
  return simple;
}

LatticeSolid::Numbers LatticeSolid::All() const {
  Numbers all;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) all.push_back(i);
  return all;
}

LatticeSolid::Numbers LatticeSolid::Touching(const LatticeBox& box, const Numbers& among) const {
  work_ += among.size();
  Numbers touching;
  for (const std::uint32_t i : among) {
    const LatticeBox& bounds = triangle_bounds_[i];
    bool is_inside = true;
    for (int axis = 0; axis < 3 && is_inside; ++axis) {
      if (bounds.low[axis] != bounds.high[axis]) {
        is_inside = bounds.high[axis] > box.low[axis] && bounds.low[axis] < box.high[axis];
      } else {
        // In a plane across the axis: the surface belongs to the side of the solid, behind the
        // normal.
        const std::int64_t place = bounds.low[axis];
        const LatticePoint normal = NormalOf(triangles_[i][0], triangles_[i][1], triangles_[i][2]);
        is_inside = (place > box.low[axis] && place < box.high[axis]) ||
                    (place == box.low[axis] && normal[axis] < 0) ||
                    (place == box.high[axis] && normal[axis] > 0);
      }
    }
    if (is_inside) touching.push_back(i);
  }
  return touching;
}

LatticeSolid::Numbers LatticeSolid::Above(const LatticeBox& box, const Numbers& among) const {
  work_ += among.size();
  Numbers above;
  for (const std::uint32_t i : among) {
    const LatticeBox& bounds = triangle_bounds_[i];
    if (bounds.high.x() > box.low.x() && bounds.low.x() < box.high.x() &&
        bounds.high.y() > box.low.y() && bounds.low.y() < box.high.y() &&
        // Everything over the floor, also above the ceiling: VolumeWithin() subtracts columns that
        // reach beyond.
        bounds.high.z() > box.low.z()) {
      above.push_back(i);
    }
  }
  return above;
}

void LatticeSolid::AppendSurface(const LatticeBox& box, const Numbers& touching,
                                 std::vector<LatticePoint>* points) const {
  work_ += touching.size();
  for (const std::uint32_t i : touching) {
    Polygon polygon(triangles_[i]);
    polygon.CutToBox(box, triangle_bounds_[i], 3);
    for (const Point& point : polygon) {
      // Rounding moves a clipped point by at most half a step, far below the tolerance of the
      // hulls.
      points->push_back(point.array().round().matrix().cast<std::int64_t>());
    }
  }
}

double LatticeSolid::VolumeWithin(const LatticeBox& box, const Numbers& above) const {
  work_ += above.size();
  const double floor = static_cast<double>(box.low.z()),
               ceiling = static_cast<double>(box.high.z());
  double volume = 0;
  for (const std::uint32_t i : above) {
    const LatticeBox& bounds = triangle_bounds_[i];
    if (bounds.high.x() <= box.low.x() || bounds.low.x() >= box.high.x() ||
        bounds.high.y() <= box.low.y() || bounds.low.y() >= box.high.y() ||
        bounds.high.z() <= box.low.z()) {
      continue;
    }
    // The column under a triangle within the box: what is under the clipped triangle, less what is
    // above the ceiling.
    Polygon column(triangles_[i]);
    column.CutToBox(box, bounds, 2);
    // Parts below the floor would count as negative columns.
    if (bounds.low.z() < box.low.z()) column.Cut(2, floor, 1);
    volume += column.VolumeAbove(floor);
    if (bounds.high.z() <= box.high.z()) continue;
    column.Cut(2, ceiling, 1);
    volume -= column.VolumeAbove(ceiling);
  }
  return volume;
}

LatticeBox LatticeSolid::SmallBoxAt(int corner, const LatticeBox& box) {
  // Small against the box, so that the test is local, but at least one step.
  constexpr std::int64_t kPart = 1000;
  LatticeBox small = box;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t length = std::max<std::int64_t>(1, (box.high[axis] - box.low[axis]) / kPart);
    if (corner >> axis & 1) {
      small.low[axis] = box.high[axis] - length;
    } else {
      small.high[axis] = box.low[axis] + length;
    }
  }
  return small;
}

bool LatticeSolid::Fills(const LatticeBox& box, int corner, const Numbers& above) const {
  const LatticeBox small = SmallBoxAt(corner, box);
  // More than half full, since a surface through the corner may fill it partly.
  return VolumeWithin(small, above) > 0.5 * (small.high - small.low).cast<double>().prod();
}

Vector3 LatticeSolid::PlaceOf(const LatticePoint& point) const {
  Vector3 place;
  for (int axis = 0; axis < 3; ++axis) {
    // Per axis: corners from cuts through vertices are restored as exactly as the vertices
    // themselves.
    const auto known = known_places_[axis].find(point[axis]);
    place[axis] = known != known_places_[axis].end()
                      ? known->second
                      : origin_[axis] + step_ * static_cast<double>(point[axis]);
  }
  return place;
}

}  // namespace smile::mesh
