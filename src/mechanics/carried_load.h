#pragma once

#include <span>
#include <vector>

#include "mechanics/joint.h"
#include "scene/solid.h"

namespace smile::mechanics {

/// Body of a world, as far as the loads of carried bodies depend on it.
struct LoadMember {
  BodyId body;
  bool is_static = false;
  bool is_carried = false;
  const scene::MassProperties* mass = nullptr;  ///< borrowed
  Vector3 p_WBcm = Vector3::Zero();             ///< center of mass [m]
};

/// What a body bears or is borne by.
struct CarriedLoad {
  double mass = 0;               ///< of all bodies joined to a carried one [kg]
  double moment = 0;             ///< moment of inertia that they add, for all axes [kg m2]
  bool is_with_carried = false;  ///< the body is carried or joined to one that is
};

/// Computes the load of each body: on carried bodies, all bodies of their groups, whatever joints
/// lie between them; on others none.
/// @param members  all bodies, by id.
std::vector<CarriedLoad> CarriedLoads(std::span<const LoadMember> members,
                                      std::span<const Joint> joints);

}  // namespace smile::mechanics
