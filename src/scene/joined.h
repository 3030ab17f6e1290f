#pragma once

#include <set>
#include <string>

#include "scene/scene_spec.h"

namespace smile::scene {

/// All ids in a scene: of objects, their parts, sliders, chains, controls and bond points.
std::set<std::string> IdsOf(const SceneSpec& scene);

/// A scene with the objects, sliders and chains of another one behind its own, so that the place of
/// each of its own objects is as before. All else is that of the first.
/// @param added  in the same unit, and none of its ids is in `scene`.
SceneSpec Joined(SceneSpec scene, SceneSpec added);

}  // namespace smile::scene
