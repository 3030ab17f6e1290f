#pragma once

#include <span>
#include <vector>

#include "physics/world.h"

namespace smile::world {

/// Returns the bodies that a closing gripper has grasped: decided once, without friction.
///
/// A body counts if it touches both fingers, its contact normals face each other across the
/// opening, and the two points lie at nearly the same depth along the fingers: the line between
/// them deviates from the finger's normal by less than pi/16.
///
/// @param left, right  contacts of each finger; the left one is on the +y side of the tool.
/// @param X_WG         the tool frame: y across the opening, z along the fingers.
/// @param opening      between the fingers [m].
/// @returns ids in ascending order, each once.
std::vector<physics::BodyId> GraspedBodies(std::span<const physics::Contact> left,
                                           std::span<const physics::Contact> right,
                                           const RigidTransform& X_WG, double opening);

}  // namespace smile::world
