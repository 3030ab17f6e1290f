#pragma once

#include <string_view>

#include "world/refusal.h"

// Names of things in refusals, which are arguments of other messages.

namespace smile::world {

/// Returns an id as refusals write it: 'b03'.
inline Refusal ObjectName(std::string_view id) {
  return texts::Say("world.object", {{"object", id}});
}
inline Refusal TableName() { return texts::Say("world.table"); }
inline Refusal RobotName() { return texts::Say("world.robot"); }

/// Returns the reason why something cannot be at a place.
inline Refusal NoRoom(Refusal object, Refusal blocker) {
  return texts::Say("world.noRoom",
                    {{"object", std::move(object)}, {"blocker", std::move(blocker)}});
}

}  // namespace smile::world
