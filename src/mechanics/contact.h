#pragma once

#include <cstddef>
#include <vector>

#include "math/rigid_transform.h"
#include "mechanics/ids.h"

namespace smile::mechanics {

/// A point where a body touches a link.
struct LinkContact {
  BodyId body;
  Vector3 p_WQ;             ///< point on the link's surface [m]
  Vector3 normal_in_world;  ///< unit, pointing from the body to the link
  double distance = 0;      ///< [m], negative when they overlap
};

/// Push on a body at a contact point in the last step.
struct Push {
  BodyId body;            ///< that is pushed
  std::size_t solid = 0;  ///< of it: index in BodySpec::solids
  BodyId by_body;         ///< that pushes; none if a link does
  int by_link = -1;       ///< of an articulation that pushes; -1: none, or its base
  Vector3 p_WQ;           ///< [m]
  Vector3 impulse_in_world = Vector3::Zero();  ///< on the body, along the normal [N s]
};

/// Objects that a body overlaps.
struct Overlaps {
  std::vector<BodyId> bodies;      ///< including static ones, by id
  bool with_articulation = false;  ///< a link or the base of one

  bool operator==(const Overlaps&) const = default;
};

}  // namespace smile::mechanics
