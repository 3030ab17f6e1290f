// All bodies are skins: sections one above the other, sewn row by row, with lids at both ends. A
// function for a shape only makes its sections. Neighbors share corners, which makes the surfaces
// closed by construction.

#include "mesh/modeling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/internal_polygon.h"

namespace smile::mesh {
namespace {

using Eigen::Vector2d;
using Index = std::uint32_t;

double FullTurn(int part, int parts) { return 2 * std::numbers::pi * part / parts; }

/// Returns true if all points of a section coincide.
bool IsTip(const Section& section) {
  return std::all_of(section.begin(), section.end(),
                     [&](const Vector3& p) { return p == section.front(); });
}

/// Adds sections as rows of corners and connects each to the row before.
class Sewing {
 public:
  struct Row {
    Index first = 0, count = 0;  ///< a tip has one corner
  };

  Row Add(const Section& section) {
    Row row{static_cast<Index>(surface_.vertices.size()), 1};
    // One corner instead of many at the same place: the triangles there would be degenerate and
    // shade badly.
    if (!IsTip(section)) row.count = static_cast<Index>(section.size());
    for (Index k = 0; k < row.count; ++k) {
      surface_.vertices.push_back(section[k].cast<float>());
    }
    return row;
  }

  void Sew(const Row& low, const Row& high) {
    // A tip has one corner: one of the two triangles per side is degenerate and left out.
    const Index sides = std::max(low.count, high.count);
    for (Index k = 0; k < sides; ++k) {
      const Index a = Corner(low, k), b = Corner(low, k + 1);
      const Index c = Corner(high, k + 1), d = Corner(high, k);
      if (a != b) surface_.triangles.push_back({a, b, c});
      if (c != d) surface_.triangles.push_back({a, c, d});
    }
  }

  /// Closes a row by a flat lid.
  /// @param is_top  true if its corners run counter-clockwise seen from outside.
  void Close(const Section& section, const Row& row, bool is_top) {
    if (row.count == 1) return;
    for (auto [a, b, c] : internal::Triangulated(section)) {
      // Triangulated() follows the section; a bottom lid faces the other way.
      if (!is_top) std::swap(b, c);
      surface_.triangles.push_back({row.first + a, row.first + b, row.first + c});
    }
  }

  scene::SurfaceMesh Take() { return std::move(surface_); }

 private:
  static Index Corner(const Row& row, Index k) { return row.first + k % row.count; }

  scene::SurfaceMesh surface_;
};

/// Checks that all sections have the same number of points.
void CheckSections(const std::vector<Section>& sections) {
  if (sections.size() < 2) throw std::invalid_argument("a skin needs two sections or more");
  for (const Section& section : sections) {
    if (section.size() < 3 || section.size() != sections.front().size()) {
      throw std::invalid_argument("a section of " + std::to_string(section.size()) +
                                  " points, expected as many as the first, at least 3");
    }
  }
}

/// Returns the center line of a tube: its corners replaced by arcs.
std::vector<Vector3> Bent(const std::vector<Vector3>& path, double bend_radius) {
  constexpr double kChord = std::numbers::pi / 8;
  std::vector<Vector3> line{path.front()};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vector3 back = path[i - 1] - path[i], ahead = path[i + 1] - path[i];
    const Vector3 u = back.normalized(), v = ahead.normalized();
    const double turn = std::numbers::pi - std::acos(std::clamp(u.dot(v), -1.0, 1.0));
    // Two bends share a side, so each takes less than half of it.
    const double room = 0.499 * std::min(back.norm(), ahead.norm());
    const double reach = std::min(bend_radius * std::tan(turn / 2), room);
    // Nearly straight: the radius would be a quotient of two tiny numbers.
    if (turn < 0.01) {
      line.push_back(path[i]);
      continue;
    }
    // Points on the arc between the tangent points, about its center.
    const double radius = reach / std::tan(turn / 2);
    const Vector3 center = path[i] + (u + v).normalized() * std::hypot(reach, radius);
    const Vector3 from = path[i] + reach * u - center;
    const Vector3 across = -u;
    const int chords = std::max(1, static_cast<int>(std::ceil(turn / kChord)));
    for (int k = 0; k <= chords; ++k) {
      const double angle = turn * k / chords;
      line.push_back(center + std::cos(angle) * from + radius * std::sin(angle) * across);
    }
  }
  line.push_back(path.back());
  return line;
}

}  // namespace

Outline CircleOutline(double radius, int sides) {
  Outline outline;
  for (int k = 0; k < sides; ++k) {
    const double angle = FullTurn(k, sides);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

Outline StadiumOutline(double length, double width, int sides) {
  const double radius = width / 2, shift = length / 2 - radius;
  Outline outline;
  const int half = sides / 2;
  // Starts below the right center and ends above it; the left half continues with both signs
  // changed.
  for (int end : {1, -1}) {
    for (int k = 0; k <= half; ++k) {
      const double angle = std::numbers::pi * (static_cast<double>(k) / half - 0.5);
      // Half a circle about either center; both run counter-clockwise.
      outline.emplace_back(end * (shift + radius * std::cos(angle)),
                           end * radius * std::sin(angle));
    }
  }
  return outline;
}

Outline RoundedOutline(const Outline& outline, double radius, int corner_sides) {
  Outline rounded;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d& corner = outline[i];
    const Vector2d back = outline[(i + n - 1) % n] - corner, ahead = outline[(i + 1) % n] - corner;
    const Vector2d u = back.normalized(), v = ahead.normalized();
    // Rounding may bring the dot product of unit vectors beyond 1, where acos() is NaN.
    const double turn = std::numbers::pi - std::acos(std::clamp(u.dot(v), -1.0, 1.0));
    const double reach =
        std::min(radius * std::tan(turn / 2), 0.499 * std::min(back.norm(), ahead.norm()));
    // A quadratic Bezier curve: close to the arc, and the same for every angle.
    for (int k = 0; k <= corner_sides; ++k) {
      const double t = static_cast<double>(k) / corner_sides;
      rounded.emplace_back(corner + (1 - t) * (1 - t) * reach * u + t * t * reach * v);
    }
  }
  return rounded;
}

Outline SuperellipseOutline(const Cut& cut, int sides) {
  const Vector2d center((cut.x_min + cut.x_max) / 2, (cut.y_min + cut.y_max) / 2);
  const Vector2d half((cut.x_max - cut.x_min) / 2, (cut.y_max - cut.y_min) / 2);
  const auto bulged = [&](double share) {
    // Parametric form: the angle is evenly spaced, the point is not.
    return std::copysign(std::pow(std::abs(share), 2 / cut.exponent), share);
  };
  Outline outline;
  for (int k = 0; k < sides; ++k) {
    const double angle = FullTurn(k, sides);
    outline.emplace_back(center.x() + half.x() * bulged(std::cos(angle)),
                         center.y() + half.y() * bulged(std::sin(angle)));
  }
  return outline;
}

Section SectionAt(const Outline& outline, double z) {
  Section section;
  for (const Vector2d& p : outline) section.emplace_back(p.x(), p.y(), z);
  return section;
}

scene::SurfaceMesh Skin(const std::vector<Section>& sections) {
  CheckSections(sections);
  Sewing sewing;
  Sewing::Row row = sewing.Add(sections.front());
  sewing.Close(sections.front(), row, false);
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const Sewing::Row next = sewing.Add(sections[i]);
    sewing.Sew(row, next);
    row = next;
  }
  sewing.Close(sections.back(), row, true);
  return sewing.Take();
}

scene::SurfaceMesh Lathe(const std::vector<Vector2d>& profile, int sides) {
  std::vector<Section> sections;
  for (const Vector2d& point : profile) {
    sections.push_back(SectionAt(CircleOutline(point.x(), sides), point.y()));
  }
  return Skin(sections);
}

scene::SurfaceMesh Extrusion(const Outline& outline, double z_min, double z_max, double edge_radius,
                             int edge_sides) {
  std::vector<Section> sections;
  const auto add = [&](double inset, double z) {
    sections.push_back(SectionAt(internal::Inset(outline, inset), z));
  };
  if (!(edge_radius > 0)) {
    add(0, z_min);
    add(0, z_max);
    return Skin(sections);
  }
  // A quarter circle at either end.
  for (int end : {0, 1}) {
    for (int k = 0; k <= edge_sides; ++k) {
      const double angle = std::numbers::pi / 2 * (end == 0 ? k : edge_sides - k) / edge_sides;
      // A quarter circle in the plane of the edge's cross section.
      const double inset = edge_radius * (1 - std::sin(angle));
      const double rise = edge_radius * (1 - std::cos(angle));
      add(inset, end == 0 ? z_min + rise : z_max - rise);
    }
  }
  return Skin(sections);
}

scene::SurfaceMesh Loft(const std::vector<Cut>& cuts, int sides) {
  std::vector<Section> sections;
  for (const Cut& cut : cuts) sections.push_back(SectionAt(SuperellipseOutline(cut, sides), cut.z));
  return Skin(sections);
}

scene::SurfaceMesh RoundedBox(const Vector3& size, double corner_radius, double edge_radius) {
  constexpr int kCornerSides = 3, kEdgeSides = 1;
  const double x = size.x() / 2, y = size.y() / 2, z = size.z() / 2;
  const Outline outline =
      RoundedOutline({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, corner_radius, kCornerSides);
  return Extrusion(outline, -z, z, edge_radius, kEdgeSides);
}

scene::SurfaceMesh Tube(const std::vector<Vector3>& path, double radius, double bend_radius,
                        int sides) {
  if (path.size() < 2) throw std::invalid_argument("a tube needs two points or more");
  const std::vector<Vector3> line = Bent(path, bend_radius);
  std::vector<Section> sections;
  Vector3 side = Vector3::Zero();
  for (std::size_t i = 0; i < line.size(); ++i) {
    // Perpendicular to the mean direction: a miter with equal angles on both sides.
    const Vector3 before = i > 0 ? (line[i] - line[i - 1]).normalized() : Vector3::Zero().eval();
    const Vector3 after =
        i + 1 < line.size() ? (line[i + 1] - line[i]).normalized() : Vector3::Zero().eval();
    // At both ends only one direction exists; the other is zero.
    const Vector3 along = (before + after).normalized();
    // Carry the side direction along by projection, so that the rows of corners do not twist.
    if (side.isZero()) side = along.unitOrthogonal();
    side = (side - side.dot(along) * along).normalized();
    const Vector3 up = along.cross(side);
    Section section;
    for (int k = 0; k < sides; ++k) {
      const double angle = FullTurn(k, sides);
      section.push_back(line[i] + radius * (std::cos(angle) * side + std::sin(angle) * up));
    }
    sections.push_back(std::move(section));
  }
  return Skin(sections);
}

scene::SurfaceMesh FlatPiece(const Outline& outline, double z) {
  const Section section = SectionAt(outline, z);
  scene::SurfaceMesh surface;
  for (const Vector3& p : section) surface.vertices.push_back(p.cast<float>());
  surface.triangles = internal::Triangulated(section);
  return surface;
}

scene::SurfaceMesh Joined(const std::vector<scene::SurfaceMesh>& pieces) {
  scene::SurfaceMesh all;
  for (const scene::SurfaceMesh& piece : pieces) {
    const auto first = static_cast<Index>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (const auto& [a, b, c] : piece.triangles) {
      all.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return all;
}

scene::SurfaceMesh Placed(const RigidTransform& X_AB, scene::SurfaceMesh surface_B) {
  for (Eigen::Vector3f& p : surface_B.vertices) p = (X_AB * p.cast<double>().eval()).cast<float>();
  return surface_B;
}

scene::SurfaceMesh Mirrored(scene::SurfaceMesh surface) {
  for (Eigen::Vector3f& p : surface.vertices) p.y() = -p.y();
  // The mirror turns triangles inside out: reverse them.
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  return surface;
}

}  // namespace smile::mesh
