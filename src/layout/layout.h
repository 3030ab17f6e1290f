#pragma once

#include <cstdint>

#include "layout/layout_level.h"
#include "layout/layout_region.h"
#include "scene/scene_spec.h"

namespace smile::layout {

/// A finger of the classic gripper, 0.03 m thick, fits beside a thing with this much room [m].
inline constexpr double kFingerGap = 0.04;

/// The same scene with its loose objects elsewhere: random places, and turns about the vertical.
///
/// Loose is what stands on the table by itself: it is not fixed, belongs to no slider, chain or
/// bond, has no controls, and touches nothing but the table. Everything else stays where it is.
/// Things are at least kFingerGap apart, and farther (up to 0.1 m) while there is room; the
/// region's strip is free while there is room beside it.
///
/// Same scene, seed and level: same layout. Each object has random numbers of its own, by its id,
/// and large things are placed before small ones: one thing more or less seldom changes where the
/// larger ones lie.
///
/// @throws std::invalid_argument if nothing is loose, or the region has no room.
scene::SceneSpec RandomLayout(scene::SceneSpec scene, std::uint64_t seed,
                              LayoutLevel level = LayoutLevel::kScattered,
                              const LayoutRegion& region = {});

}  // namespace smile::layout
