#pragma once

#include "scene/solid.h"

namespace smile::world {

/// Bodies bounce with the product of both restitutions: with 1 here, an object's own one counts.
inline constexpr double kGroundRestitution = 1;

/// What catches things that leave the table.
scene::Solid FloorSolid();

}  // namespace smile::world
