#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "mesh/internal_lattice_hull.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

/// A cuboid along the axes of the lattice; what lies in a face belongs to the side its solid is on.
struct LatticeBox {
  LatticePoint low, high;
};

/// A surface moved onto a lattice as fine as floats nearly are, which also closes cracks of
/// rounding, and exact answers about the solid it bounds.
class LatticeSolid {
 public:
  using Triangle = std::array<LatticePoint, 3>;
  using Numbers = std::vector<std::uint32_t>;  ///< of triangles

  /// @param mesh  not empty.
  explicit LatticeSolid(const scene::SurfaceMesh& mesh);

  /// With vertices that are near to each other made one, until there are at most so many triangles
  /// or they were a sixtieth of the whole apart. A closed surface stays closed.
  LatticeSolid Simplified(std::size_t max_triangles) const;

  const std::vector<Triangle>& triangles() const { return triangles_; }
  LatticeBox bounds() const { return bounds_; }
  /// Whether the triangles bound a solid that is not next to nothing.
  bool is_closed() const { return is_closed_; }
  double volume() const { return volume_; }  ///< [steps3]; of a closed one at least 0

  /// Those of `among` that may have to do with the solid inside the box: with its surface there,
  /// or from there on upwards.
  Numbers Touching(const LatticeBox& box, const Numbers& among) const;
  Numbers Above(const LatticeBox& box, const Numbers& among) const;
  Numbers All() const;

  /// Where the solid within a box has its surface: corners of the triangles cut off at the box,
  /// rounded to the lattice. Together with the corners of the box that lie in the solid they span
  /// the hull of the solid within the box.
  void AppendSurface(const LatticeBox& box, const Numbers& touching,
                     std::vector<LatticePoint>* points) const;

  /// Of the solid within the box, exactly: the signed sum over all triangles of what lies under
  /// them [steps3].
  double VolumeWithin(const LatticeBox& box, const Numbers& above) const;

  /// Whether the solid fills the box near its corner; 0 to 7, one bit for each axis.
  bool Fills(const LatticeBox& box, int corner, const Numbers& above) const;
  /// Where that is looked at.
  static LatticeBox SmallBoxAt(int corner, const LatticeBox& box);

  /// In the mesh's own units; what was a vertex's number is that number again.
  Vector3 PlaceOf(const LatticePoint& point) const;

  /// Triangles that were looked at so far: what a decomposition costs, whatever the machine.
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

LatticePoint CornerOf(const LatticeBox& box, int corner);

}  // namespace smile::mesh
