#pragma once

#include "layout/layout_region.h"
#include "model/robot_placement.h"

namespace smile::experiment {

/// Returns the region of seeded layouts for a robot in its place.
///
/// Nothing may stand where the robot is at the start. Apart from that, Baxter has the measured
/// region. For other robots it is computed: the middle of a cell of the map is reached if an arm
/// can grasp a cube of this height [m] there from above, however it is turned, and lift it straight
/// up by its height, without touching itself. Takes tenths of a second per arm. The last regions
/// are kept, by the content of the robot's files. Deterministic; thread-safe.
layout::LayoutRegion RegionOf(const model::RobotPlacement& robot, double object_height);

}  // namespace smile::experiment
