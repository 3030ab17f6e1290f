// Meshes of the basic shapes for drawing. Each face that has its own normal has its own corners;
// round shapes share corners, whose normals are those of the true surface. Deterministic order of
// corners: pictures and caches depend on it.

#include "mesh/primitives.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/overloaded.h"
#include "mesh/internal_smooth_surface.h"

namespace smile::mesh {
namespace {

using Eigen::Vector3f;

std::uint32_t AddCorner(const Vector3f& position, const Vector3f& normal, TriangleMesh* mesh) {
  mesh->positions.push_back(position);
  mesh->normals.push_back(normal);
  return static_cast<std::uint32_t>(mesh->positions.size() - 1);
}

/// Makes a unit cube, with four corners of its own per face since normals differ.
TriangleMesh MakeBlock() {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const Vector3f normal = side * Vector3f::Unit(axis);
      // Two edges of the face with edge x other_edge = normal.
      const Vector3f edge = Vector3f::Unit((axis + 1) % 3);
      const Vector3f other_edge = normal.cross(edge);
      const auto corner = [&](float u, float v) {
        return AddCorner(0.5f * (normal + u * edge + v * other_edge), normal, &mesh);
      };
      // Counter-clockwise seen from outside, in two triangles.
      const std::uint32_t a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1),
                          d = corner(-1, 1);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// Returns points of the unit circle in the plane of z and x, counter-clockwise seen from +y.
std::vector<Vector3f> CircleAboutY(int facets) {
  std::vector<Vector3f> circle;
  for (int k = 0; k < facets; ++k) {
    const double angle = 2 * std::numbers::pi * k / facets;
    circle.emplace_back(static_cast<float>(std::sin(angle)), 0.0f,
                        static_cast<float>(std::cos(angle)));
  }
  return circle;
}

/// Adds a flat cap at y = side / 2.
void AddCap(const std::vector<Vector3f>& circle, float side, TriangleMesh* mesh) {
  const Vector3f normal = side * Vector3f::UnitY();
  const std::uint32_t center = AddCorner(0.5f * normal, normal, mesh);
  for (const Vector3f& point : circle) AddCorner(0.5f * (point + normal), normal, mesh);
  const auto facets = static_cast<std::uint32_t>(circle.size());
  for (std::uint32_t k = 0; k < facets; ++k) {
    const std::uint32_t here = center + 1 + k, next = center + 1 + (k + 1) % facets;
    // Counter-clockwise seen from outside: the lower cap is reversed.
    mesh->triangles.push_back({center, side > 0 ? here : next, side > 0 ? next : here});
  }
}

/// Makes a unit cylinder: smooth sides with radial normals, then both caps.
TriangleMesh MakeCylinder(int facets) {
  TriangleMesh mesh;
  const std::vector<Vector3f> circle = CircleAboutY(facets);
  for (const Vector3f& point : circle) {
    AddCorner(0.5f * (point - Vector3f::UnitY()), point, &mesh);
    AddCorner(0.5f * (point + Vector3f::UnitY()), point, &mesh);
  }
  const auto num_corners = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t low = 0; low < num_corners; low += 2) {
    const std::uint32_t next_low = (low + 2) % num_corners;
    mesh.triangles.push_back({low, next_low, next_low + 1});
    mesh.triangles.push_back({low, next_low + 1, low + 1});
  }
  AddCap(circle, -1, &mesh);
  AddCap(circle, 1, &mesh);
  return mesh;
}

/// Makes a unit sphere from rings of latitude.
TriangleMesh MakeSphere(int facets) {
  TriangleMesh mesh;
  const std::vector<Vector3f> circle = CircleAboutY(facets);
  const int num_rings = std::max(1, facets / 2 - 1);  // between the poles
  const auto add = [&mesh](const Vector3f& normal) {
    return AddCorner(0.5f * normal, normal, &mesh);
  };

  // Corners: south pole, rings from south to north, north pole.
  const std::uint32_t south = add(-Vector3f::UnitY());
  for (int ring = 1; ring <= num_rings; ++ring) {
    // Rings at equal angles of latitude, without the poles.
    const double latitude = std::numbers::pi * (static_cast<double>(ring) / (num_rings + 1) - 0.5);
    const auto width = static_cast<float>(std::cos(latitude));
    const auto height = static_cast<float>(std::sin(latitude));
    for (const Vector3f& point : circle) add(width * point + height * Vector3f::UnitY());
  }
  const std::uint32_t north = add(Vector3f::UnitY());

  const auto n = static_cast<std::uint32_t>(facets);
  // The first corner of the northernmost ring.
  const std::uint32_t last_ring = north - n;
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    mesh.triangles.push_back({south, 1 + next, 1 + k});
    for (std::uint32_t low = 1; low < last_ring; low += n) {
      mesh.triangles.push_back({low + k, low + next, low + n + next});
      mesh.triangles.push_back({low + k, low + n + next, low + n + k});
    }
    mesh.triangles.push_back({last_ring + k, last_ring + next, north});
  }
  return mesh;
}

/// Makes a mesh of flat faces; each face has corners of its own.
TriangleMesh MakeHull(const scene::Polyhedron& polyhedron) {
  TriangleMesh mesh;
  for (const scene::Polyhedron::Face& face : polyhedron.faces) {
    const Vector3f normal = polyhedron.AreaVectorOf(face).normalized().cast<float>();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const std::uint32_t corner : face) {
      AddCorner(polyhedron.corners[corner].cast<float>(), normal, &mesh);
    }
    for (std::uint32_t k = 2; k < face.size(); ++k) {
      // Faces are convex, so a fan covers them.
      mesh.triangles.push_back({first, first + k - 1, first + k});
    }
  }
  return mesh;
}

/// Lexicographic order; weak_order() also orders NaN.
std::weak_ordering Compare(const Vector3f& a, const Vector3f& b) {
  for (int i = 0; i < 3; ++i) {
    if (const auto order = std::weak_order(a[i], b[i]); order != 0) return order;
  }
  return std::weak_ordering::equivalent;
}

}  // namespace

std::weak_ordering SharedSurface::operator<=>(const SharedSurface& other) const {
  // The same object needs no comparison of its contents.
  if (mesh == other.mesh) return std::weak_ordering::equivalent;
  if (!mesh || !other.mesh) return !mesh <=> !other.mesh;
  const scene::SurfaceMesh &a = mesh->surface, &b = other.mesh->surface;
  // Sizes first: a cheap test that separates most surfaces.
  if (const auto order = a.vertices.size() <=> b.vertices.size(); order != 0) return order;
  const auto vertices = std::lexicographical_compare_three_way(
      a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), Compare);
  return vertices != 0 ? vertices : a.triangles <=> b.triangles;
}

UnitMesh UnitMeshOf(const scene::VisualShape& shape, int sphere_facets) {
  return std::visit(
      Overloaded{
          [](const scene::Block&) { return UnitMesh{}; },
          [](const scene::Cylinder& cylinder) {
            // A scene may ask for any number of sides.
            return UnitMesh{UnitMesh::Kind::kCylinder, std::clamp(cylinder.sides, 3, kMaxFacets)};
          },
          [&](const scene::Sphere&) {
            return UnitMesh{UnitMesh::Kind::kSphere, sphere_facets};
          },
          [](const scene::Hull& hull) {
            return UnitMesh{UnitMesh::Kind::kHull, 0, hull};
          },
          [](const scene::DrawnMesh& drawn) {
            return UnitMesh{UnitMesh::Kind::kSurface, 0, {}, {drawn.mesh}};
          }},
      shape);
}

Vector3 ScaleOf(const scene::VisualShape& shape) {
  return std::visit(
      Overloaded{
          [](const scene::Block& block) { return block.size; },
          [](const scene::Cylinder& cylinder) {
            return Vector3(2 * cylinder.radius, cylinder.length, 2 * cylinder.radius);
          },
          [](const scene::Sphere& sphere) { return Vector3(Vector3::Constant(2 * sphere.radius)); },
          [](const scene::Hull&) { return Vector3(Vector3::Ones()); },
          [](const scene::DrawnMesh& mesh) { return Vector3(Vector3::Constant(mesh.scale)); }},
      shape);
}

double BoundingRadiusOf(const scene::VisualShape& shape) {
  double radius = 0;
  if (const auto* drawn = std::get_if<scene::DrawnMesh>(&shape)) {
    for (const Vector3f& vertex : drawn->mesh->surface.vertices) {
      radius = std::max(radius, vertex.cast<double>().squaredNorm());
    }
    return std::sqrt(radius) * drawn->scale;
  }
  const auto* hull = std::get_if<scene::Hull>(&shape);
  // Half of the diagonal of the bounding box, which is centered at the origin for these shapes.
  if (!hull) return ScaleOf(shape).norm() / 2;
  for (const Vector3& corner : hull->polyhedron().corners) radius = std::max(radius, corner.norm());
  return radius;
}

TriangleMesh MakeMesh(const UnitMesh& unit_mesh) {
  if (unit_mesh.kind == UnitMesh::Kind::kBlock) return MakeBlock();
  if (unit_mesh.kind == UnitMesh::Kind::kHull) return MakeHull(unit_mesh.hull.polyhedron());
  if (unit_mesh.kind == UnitMesh::Kind::kSurface) {
    return SmoothSurface(unit_mesh.surface.mesh->surface);
  }
  // UnitMeshOf() clamps; other callers may not.
  if (unit_mesh.facets < 3 || unit_mesh.facets > kMaxFacets) {
    throw std::invalid_argument("a round mesh has " + std::to_string(unit_mesh.facets) +
                                " facets, expected 3 to " + std::to_string(kMaxFacets));
  }
  return unit_mesh.kind == UnitMesh::Kind::kCylinder ? MakeCylinder(unit_mesh.facets)
                                                     : MakeSphere(unit_mesh.facets);
}

TriangleMesh MeshOf(const scene::VisualShape& shape) {
  return Scaled(MakeMesh(UnitMeshOf(shape)), ScaleOf(shape).cast<float>());
}

}  // namespace smile::mesh
