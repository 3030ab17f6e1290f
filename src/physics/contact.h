#pragma once

#include <vector>

#include "math/rigid_transform.h"
#include "physics/definitions.h"

namespace smile::physics {

/// A point where a body touches a link.
struct Contact {
  BodyId body;
  Vector3 p_WQ;             ///< point on the link's surface [m]
  Vector3 normal_in_world;  ///< unit, pointing from the body to the link
  double distance = 0;      ///< [m], negative when they overlap
};

/// Objects that a body overlaps.
struct Overlaps {
  std::vector<BodyId> bodies;      ///< including static ones, by id
  bool with_articulation = false;  ///< a link or the base of one

  bool operator==(const Overlaps&) const = default;
};

}  // namespace smile::physics
