#pragma once

#include <cstddef>
#include <set>

#include "scene/scene_spec.h"

namespace smile::experiment::internal {

/// Returns the indices of the objects of a scene that are links or ends of chains.
std::set<std::size_t> ChainObjects(const scene::SceneSpec& scene);

}  // namespace smile::experiment::internal
