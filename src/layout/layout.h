#pragma once

#include <cstdint>

#include "layout/layout_level.h"
#include "layout/layout_region.h"
#include "scene/scene_spec.h"

namespace smile::layout {

/// Room in which a finger of the classic gripper, 0.03 m thick, fits beside an object [m].
inline constexpr double kFingerGap = 0.04;

/// Returns the scene with random positions of its loose objects, rotated about the vertical.
///
/// An object is loose if it stands on the table by itself: not fixed, part of no slider, chain or
/// bond, without controls, and in contact with the table only. Everything else keeps its place,
/// except at LayoutLevel::kFixtures: there, fixed objects are displaced by up to 0.05 m and turned
/// by up to 15 degrees, each with what it overlaps from above, such as the drives in a rack; and at
/// LayoutLevel::kPiles, where piles of objects are placed like loose ones, each as a whole.
/// Objects are at least kFingerGap apart, and up to 0.1 m while there is room; the region's strip
/// stays free while there is room beside it.
///
/// Deterministic: the same scene, seed and level give the same layout. Each object has random
/// numbers of its own, by its id, and large objects are placed before small ones: adding or
/// removing one object seldom moves the larger ones.
///
/// @throws std::invalid_argument if there is nothing to move, or the region has no room.
scene::SceneSpec RandomLayout(scene::SceneSpec scene, std::uint64_t seed,
                              LayoutLevel level = LayoutLevel::kScattered,
                              const LayoutRegion& region = {});

/// Returns the height of the highest loose object above the table [m]; 0 if there is none.
double HeightOfLooseObjects(const scene::SceneSpec& scene);

}  // namespace smile::layout
