#pragma once

#include <memory>
#include <optional>

#include "sim/command.h"
#include "world/tabletop.h"

// What a command may add to a scene.

namespace smile::sim {

/// By one command, and in all: each adds to what every tick costs and every recording holds.
inline constexpr int kMaxSpawnedObjects = 2'000;
inline constexpr std::size_t kMaxObjects = 10'000;

/// A scene with what a command adds behind its own, see scene::Joined(). Depends on these two
/// alone.
/// @returns nullopt if the text is no scene or what it has cannot be added; `refusal` then says
/// why:
///          ids that are in the scene already, also of objects that are gone; another unit or
///          table; cameras; files, which a command cannot name; too much of it.
std::optional<scene::SceneSpec> WithSpawned(const scene::SceneSpec& scene, const Spawn& spawn,
                                            world::Refusal* refusal);

/// The same as a model.
/// @returns nullptr if it cannot be added.
std::shared_ptr<const model::Model> GrownModel(const model::Model& model, const Spawn& spawn,
                                               world::Refusal* refusal);

/// Why there is no room for what `grown` has more than the tabletop: it would be in objects, or in
/// the robot.
std::optional<world::Refusal> RefuseOverlap(const model::Model& grown,
                                            const world::Tabletop& tabletop,
                                            const physics::World& world);

}  // namespace smile::sim
