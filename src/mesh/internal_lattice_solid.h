#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "mesh/internal_lattice_hull.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

/// Cuboid along the axes of the lattice. Surface in the plane of a face belongs to the box on whose
/// side the solid is.
struct LatticeBox {
  LatticePoint low, high;
};

/// A surface on a lattice nearly as fine as floats, which also closes cracks of rounding, with
/// exact queries about the solid that it bounds.
class LatticeSolid {
 public:
  using Triangle = std::array<LatticePoint, 3>;
  using Numbers = std::vector<std::uint32_t>;  ///< indices of triangles

  /// @param mesh  not empty.
  explicit LatticeSolid(const scene::SurfaceMesh& mesh);

  /// Returns a copy in which nearby vertices are merged, until there are at most `max_triangles` or
  /// the merging distance reaches 1/64 of the size. A closed surface stays closed.
  LatticeSolid Simplified(std::size_t max_triangles) const;

  const std::vector<Triangle>& triangles() const { return triangles_; }
  LatticeBox bounds() const { return bounds_; }
  /// True if the triangles bound a solid: each edge is shared in both directions equally often.
  bool is_closed() const { return is_closed_; }
  double volume() const { return volume_; }  ///< [steps3]; at least 0

  /// Return the triangles among some that matter for the solid in a box: Touching() for its surface
  /// in the box, Above() for its volume there, which needs all triangles over the floor of the box.
  Numbers Touching(const LatticeBox& box, const Numbers& among) const;
  Numbers Above(const LatticeBox& box, const Numbers& among) const;
  Numbers All() const;

  /// Appends the corners of the surface within a box: of the triangles clipped at the box, rounded
  /// to the lattice. Together with the corners of the box inside the solid they span the hull of
  /// the solid in the box.
  void AppendSurface(const LatticeBox& box, const Numbers& touching,
                     std::vector<LatticePoint>* points) const;

  /// Returns the volume of the solid in a box: the signed sum over all triangles of the volume
  /// under them [steps3].
  double VolumeWithin(const LatticeBox& box, const Numbers& above) const;

  /// Returns true if the solid fills a box near one of its corners; 0 to 7, one bit per axis.
  bool Fills(const LatticeBox& box, int corner, const Numbers& above) const;
  /// Returns the small box at a corner in which Fills() measures.
  static LatticeBox SmallBoxAt(int corner, const LatticeBox& box);

  /// Returns a point in the mesh's own units; coordinates of vertices are restored exactly.
  Vector3 PlaceOf(const LatticePoint& point) const;

  /// Returns the number of triangles visited so far: the cost of a decomposition, independent of
  /// the machine.
  std::size_t work() const { return work_; }

 private:
  void SetTriangles(std::vector<Triangle> triangles);

  std::vector<Triangle> triangles_;
  std::vector<LatticeBox> triangle_bounds_;
  LatticeBox bounds_;
  bool is_closed_ = false;
  double volume_ = 0;
  Vector3 origin_;
  double step_ = 1;
  std::array<std::map<std::int64_t, double>, 3> known_places_;  // of vertices, per axis
  mutable std::size_t work_ = 0;
};

/// Returns a corner of a box, 0 to 7: bit i chooses the high side along axis i.
LatticePoint CornerOf(const LatticeBox& box, int corner);

}  // namespace smile::mesh
