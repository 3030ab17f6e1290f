#pragma once

#include <string>

#include "scene/scene_spec.h"
#include "scene_import/foreign_world.h"

namespace smile::scene_import {

/// Makes a scene of a world.
/// @param table  as ImportSceneOptions::table.
scene::SceneSpec SceneOfWorld(const ForeignWorld& world, const std::string& table,
                              ImportFindings* findings);

}  // namespace smile::scene_import
