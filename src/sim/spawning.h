#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scene_xml/scene_reader.h"
#include "sim/command.h"
#include "world/tabletop.h"

// Scenes in commands: allowed contents, and what they may add to a scene.

namespace smile::sim {

/// Limits of the scene of one command, and of all objects: each adds to the cost of each tick and
/// to the size of recordings.
inline constexpr scene_xml::SceneLimits kCommandSceneLimits{.max_elements = 20'000,
                                                            .max_objects = 2'000};
inline constexpr std::size_t kMaxObjects = 10'000;
/// Greatest overlap of objects that only touch [m].
inline constexpr double kTouching = 0.0005;

/// Reads the scene text of a command, which cannot name files.
/// @param name  of the scene, and of the text in diagnostics.
scene_xml::SceneReading ReadCommandScene(std::string_view xml, const std::string& name);

/// Returns a scene with the objects that a command adds behind its own, see scene::Joined().
/// Depends on its arguments only.
/// @returns nullopt if the text is not a scene or its contents cannot be added, with the reason in
///          `refusal`: ids that are already in the scene, also of destroyed objects; another unit
///          or table; cameras; files, which a command cannot name; too many objects.
std::optional<scene::SceneSpec> WithSpawned(const scene::SceneSpec& scene, const Spawn& spawn,
                                            world::Refusal* refusal);

/// The same as a model.
/// @returns nullptr if it cannot be added.
std::shared_ptr<const model::Model> GrownModel(const model::Model& model, const Spawn& spawn,
                                               world::Refusal* refusal);

/// Returns the reason why there is no room for the objects that `grown` has beyond the tabletop:
/// they would overlap objects or the robot.
std::optional<world::Refusal> RefuseOverlap(const model::Model& grown,
                                            const world::Tabletop& tabletop,
                                            const physics::World& world);

}  // namespace smile::sim
