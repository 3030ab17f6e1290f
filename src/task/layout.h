#pragma once

#include "scene/scene_spec.h"

namespace smile::task {

/// Where a seeded layout may put things: within Baxter's reach with both arms' help
/// (docs/robot.md), clear of one another by more than a gripper's width.
struct LayoutRegion {
  double x_low = -0.42, x_high = 0.42;  ///< [m]
  double y_low = -0.44, y_high = -0.16;
  double min_distance = 0.26;  ///< between centres [m]
};

/// The same scene with its movable objects elsewhere: random places and turns about the vertical,
/// at the heights they had. Same seed, same layout.
/// @throws std::invalid_argument if the region has no room for them.
scene::SceneSpec RandomLayout(scene::SceneSpec scene, std::uint64_t seed,
                              const LayoutRegion& region = {});

}  // namespace smile::task
