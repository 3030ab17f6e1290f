#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "layout/layout_region.h"
#include "scene/scene_spec.h"

namespace smile::layout {

/// Greatest displacement along x and y, and rotation, of a fixture in a layout.
inline constexpr double kFixtureOffset = 0.05, kFixtureTurnDeg = 15;  // [m], [degrees]

/// Partitions the objects that are not loose into fixtures: what is joined by a slider or a chain,
/// and what overlaps as seen from above, belongs together.
/// @returns indices in SceneSpec::objects, each once, in ascending order.
std::vector<std::vector<std::size_t>> FixturesOf(const scene::SceneSpec& scene,
                                                 const std::vector<std::size_t>& loose);

/// Moves each fixture by a random displacement and a random rotation about the vertical, except for
/// loose objects. Fixtures keep a distance of kFingerGap from one another and stay where the robot
/// reaches and sees them, as far as they do so in the scene.
void MoveFixtures(std::uint64_t seed, const std::vector<std::size_t>& loose,
                  const LayoutRegion& region, scene::SceneSpec* scene);

}  // namespace smile::layout
