#pragma once

#include <compare>
#include <memory>

#include "mesh/triangle_mesh.h"
#include "scene/visual_model.h"

namespace smile::mesh {

/// Surface of a mesh file, shared and compared by content.
struct SharedSurface {
  std::shared_ptr<const scene::CustomMesh> mesh;

  bool operator==(const SharedSurface& other) const { return (*this <=> other) == 0; }
  /// Strict order for maps, the same in each run.
  std::weak_ordering operator<=>(const SharedSurface& other) const;
};

/// Mesh that spans one meter along x, y and z about the origin. Shapes that differ in size only
/// share one, scaled by ScaleOf(), so that many are drawn in one draw call. A hull is a unit mesh
/// of its own, in its true size; the surface of a mesh file is one in the file's unit.
struct UnitMesh {
  enum class Kind { kBlock, kCylinder, kSphere, kHull, kSurface };

  Kind kind = Kind::kBlock;
  int facets = 0;         ///< of a round shape: around the axis, at least 3; else 0
  scene::Hull hull;       ///< of a hull
  SharedSurface surface;  ///< of a surface

  auto operator<=>(const UnitMesh&) const = default;
};

/// Maximum number of facets: more make no visible difference at any image size in use.
inline constexpr int kMaxFacets = 1024;
inline constexpr int kSphereFacets = 32;

/// Returns the unit mesh of a shape. A cylinder has its own number of `sides`, within 3 and
/// kMaxFacets; a sphere has `sphere_facets`.
UnitMesh UnitMeshOf(const scene::VisualShape& shape, int sphere_facets = kSphereFacets);

/// Returns the factors that scale a shape's unit mesh along its own x, y, z: its full lengths [m];
/// 1 for a hull; the length of its unit for a surface.
Vector3 ScaleOf(const scene::VisualShape& shape);

/// Returns the radius of a sphere about the shape's origin that contains it [m].
double BoundingRadiusOf(const scene::VisualShape& shape);

/// Makes the triangles. A block has 12 flat triangles; a cylinder (axis y) `facets` smooth ones
/// around and two flat caps; a sphere `facets` meridians from pole (+y) to pole; a hull flat faces.
/// Corners of round shapes lie on the true surface. A surface is smooth over edges of less than 30
/// degrees.
/// @throws std::invalid_argument unless a round shape's facets are within 3 and kMaxFacets.
TriangleMesh MakeMesh(const UnitMesh& unit_mesh);

/// Returns the shape's own mesh, in its true size.
TriangleMesh MeshOf(const scene::VisualShape& shape);

}  // namespace smile::mesh
