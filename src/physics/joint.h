#pragma once

#include <vector>

#include "math/rigid_transform.h"
#include "physics/ids.h"

namespace smile::physics {

/// Holds a body in a fixed place on a link of an articulation, as a gripper holds a block. The body
/// is carried (weightless) and does not collide with the links that are listed.
struct WeldSpec {
  ArticulationId articulation;
  int link = -1;
  BodyId body;
  RigidTransform X_LB;
  std::vector<int> links_not_colliding;

  bool operator==(const WeldSpec&) const = default;
};

/// A joint between two things of a World.
struct Joint {
  JointId id;
  WeldSpec spec;

  bool operator==(const Joint&) const = default;
};

}  // namespace smile::physics
