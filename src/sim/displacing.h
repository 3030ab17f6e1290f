#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/world.h"
#include "sim/command.h"
#include "world/tabletop.h"

namespace smile::sim {

/// Returns the reason why a command cannot name these objects: one is named twice.
std::optional<world::Refusal> RefuseRepeated(const std::vector<std::string>& objects);

/// Moves objects together, with what is connected to them, at once and without a hand. They then
/// rest, and everything wakes.
/// @returns the reason if that is not possible: an object is missing, fixed, or held; or another
///          object, the table or the robot is in the way. Nothing has changed then.
std::optional<world::Refusal> DisplaceObjects(const Displace& displace,
                                              const world::Tabletop& tabletop,
                                              physics::World* world);

}  // namespace smile::sim
