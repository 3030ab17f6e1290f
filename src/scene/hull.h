#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "math/rigid_transform.h"

namespace smile::scene {

/// A body bounded by flat faces.
struct Polyhedron {
  /// Numbers of corners, counter-clockwise seen from outside; at least three.
  using Face = std::vector<std::uint32_t>;

  std::vector<Vector3> corners;  ///< [m]
  std::vector<Face> faces;       ///< flat; together they close the body

  /// Outwards, as long as the face is large [m2].
  Vector3 AreaVectorOf(const Face& face) const;

  bool operator==(const Polyhedron&) const = default;
};

/// A convex polyhedron, in its own frame.
///
/// It never changes, and copies share it: each solid, visual and picture has a copy, and a ring is
/// made of dozens of equal pieces.
class Hull {
 public:
  Hull() = default;  ///< without corners
  /// The caller sees to it that the polyhedron is closed and convex.
  /// @throws std::invalid_argument if a corner is not finite, or a face has fewer than three
  /// corners
  ///         or one that does not exist.
  explicit Hull(Polyhedron polyhedron);

  const Polyhedron& polyhedron() const;

  bool operator==(const Hull& other) const;
  /// Some order, for maps.
  std::weak_ordering operator<=>(const Hull& other) const;

 private:
  std::shared_ptr<const Polyhedron> shared_;
};

/// `factor` times as large, about the origin.
Hull Scaled(const Hull& hull, double factor);

/// How the volume of a body lies about its frame S.
struct VolumeMoments {
  double volume = 0;                       ///< [m3]
  Vector3 center = Vector3::Zero();        ///< of the volume, in S [m]
  Matrix3 unit_inertia = Matrix3::Zero();  ///< about the center, along S's axes, for 1 kg [m2]
};

/// Exact, by adding up a tetrahedron for each triangle of the faces.
VolumeMoments MomentsOf(const Hull& hull);

}  // namespace smile::scene
