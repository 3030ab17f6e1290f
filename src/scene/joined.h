#pragma once

#include <set>
#include <string>

#include "scene/scene_spec.h"

namespace smile::scene {

/// Returns all ids in a scene: of objects, their parts, sliders, chains, controls and bond points.
std::set<std::string> IdsOf(const SceneSpec& scene);

/// Returns a scene with the objects, sliders and chains of another one after its own, so that the
/// indices of its own objects are unchanged. Everything else is that of the first.
/// @param added  in the same unit, and none of its ids is in `scene`.
SceneSpec Joined(SceneSpec scene, SceneSpec added);

/// Returns what was added to a scene: `Joined(scene, AddedTo(scene, joined))` is `joined`.
/// @param joined  the scene with others after its own objects, sliders and chains.
SceneSpec AddedTo(const SceneSpec& scene, SceneSpec joined);

}  // namespace smile::scene
