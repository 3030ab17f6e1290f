#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scene_xml/scene_reader.h"
#include "sim/command.h"
#include "world/tabletop.h"

// Scenes in commands: what may be in their texts, and what they may add to a scene.

namespace smile::sim {

/// Of the scene of one command, and of all objects: each adds to what every tick costs and every
/// recording holds.
inline constexpr scene_xml::SceneLimits kCommandSceneLimits{.max_elements = 20'000,
                                                            .max_objects = 2'000};
inline constexpr std::size_t kMaxObjects = 10'000;

/// Reads the scene text of a command, which can name no files.
/// @param name  of the scene, and of the text in diagnostics.
scene_xml::SceneReading ReadCommandScene(std::string_view xml, const std::string& name);

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
