#pragma once

#include <optional>
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
std::vector<physics::BodyId> GraspedBodies(std::span<const physics::LinkContact> left,
                                           std::span<const physics::LinkContact> right,
                                           const RigidTransform& X_WG, double opening);

/// Returns the bodies that two jaws have grasped: those that both touch, such that the line between
/// the two points deviates by less than 45 degrees from the contact normal at each. The jaws may
/// have any directions. Source: V.-D. Nguyen, "Constructing Force-Closure Grasps" (1988), for two
/// contacts with friction.
/// @returns ids in ascending order, each once.
std::vector<physics::BodyId> BodiesBetweenJaws(std::span<const physics::LinkContact> left,
                                               std::span<const physics::LinkContact> right);

/// Returns the body that closes a suction cup: it touches the cup within `radius` [m] of the tool's
/// origin, with a surface that deviates by less than 30 degrees from the plane of the cup. Of
/// several the one whose contact is nearest to the origin; nullopt if there is none.
/// @param contacts  of the link that carries the cup.
/// @param X_WG      the tool frame: z points out of the cup.
std::optional<physics::BodyId> BodyAtCup(std::span<const physics::LinkContact> contacts,
                                         const RigidTransform& X_WG, double radius);

}  // namespace smile::world
