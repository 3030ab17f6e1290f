#pragma once

#include <array>

#include "math/rigid_transform.h"

namespace smile::impulses {

/// Returns two unit vectors that span the plane of a contact.
inline std::array<Vector3, 2> AxesOfPlane(const Vector3& normal) {
  // The world's axis that is farthest from the normal is never parallel to it.
  Vector3::Index farthest = 0;
  normal.cwiseAbs().minCoeff(&farthest);
  const Vector3 first = normal.cross(Vector3::Unit(farthest)).normalized();
  return {first, normal.cross(first)};
}

}  // namespace smile::impulses
