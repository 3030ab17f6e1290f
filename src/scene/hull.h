#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "math/rigid_transform.h"

namespace smile::scene {

/// Body bounded by flat faces.
struct Polyhedron {
  /// Indices of corners, counter-clockwise seen from outside; at least three.
  using Face = std::vector<std::uint32_t>;

  std::vector<Vector3> corners;  ///< [m]
  std::vector<Face> faces;       ///< flat; together they close the body

  /// Returns the outward normal of a face, with the length of its area [m2].
  Vector3 AreaVectorOf(const Face& face) const;

  bool operator==(const Polyhedron&) const = default;
};

/// Convex polyhedron, in its own frame.
///
/// Immutable and shared by its copies: each solid, visual and picture has a copy, and a ring is
/// made of dozens of equal pieces.
class Hull {
 public:
  Hull() = default;  ///< without corners
  /// The polyhedron must be closed and convex; this is not checked.
  /// @throws std::invalid_argument if a corner is not finite, or a face has fewer than three
  /// corners
  ///         or one that does not exist.
  explicit Hull(Polyhedron polyhedron);

  const Polyhedron& polyhedron() const;

  bool operator==(const Hull& other) const;
  /// Arbitrary strict weak order, for maps.
  std::weak_ordering operator<=>(const Hull& other) const;

 private:
  std::shared_ptr<const Polyhedron> shared_;
};

/// Returns the hull scaled by `factor` about the origin.
Hull Scaled(const Hull& hull, double factor);

/// Volume of a body and its first and second moments, in its frame S.
struct VolumeMoments {
  double volume = 0;                       ///< [m3]
  Vector3 center = Vector3::Zero();        ///< of the volume, in S [m]
  Matrix3 unit_inertia = Matrix3::Zero();  ///< about the center, along S's axes, for 1 kg [m2]
};

/// Returns the exact moments, as a sum over tetrahedra from the triangles of all faces.
VolumeMoments MomentsOf(const Hull& hull);

}  // namespace smile::scene
