#pragma once

#include "scene/solid.h"

namespace smile::world {

/// Restitution of the ground. Bullet multiplies both bodies' restitutions: with 1 here, the
/// object's own value applies.
inline constexpr double kGroundRestitution = 1;

/// Returns the floor that catches objects that leave the table.
scene::Solid FloorSolid();

}  // namespace smile::world
