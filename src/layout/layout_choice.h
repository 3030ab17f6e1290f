#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "layout/layout_level.h"
#include "layout/layout_region.h"
#include "scene/scene_spec.h"

namespace smile::layout {

/// Choice of the starting positions of the loose objects of a scene.
struct LayoutChoice {
  std::optional<std::uint64_t> seed;  ///< nullopt: the positions in the scene file
  LayoutLevel level = LayoutLevel::kScattered;
};

/// Returns the scene with the chosen starting positions, see RandomLayout().
/// @param region  called if a layout is made: that of the robot, for the height of the highest
/// loose
///                object [m].
/// @throws std::invalid_argument if such a layout is not possible.
scene::SceneSpec LaidOut(scene::SceneSpec scene, const LayoutChoice& choice,
                         const std::function<LayoutRegion(double object_height)>& region);

}  // namespace smile::layout
