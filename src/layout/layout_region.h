#pragma once

#include "layout/footprint.h"
#include "scene/scene_spec.h"

namespace smile::layout {

/// Where on the table a seeded layout may put things: within Baxter's reach, in view of its eye,
/// and not where the robot is to build (docs/experiments.md). Depths count from the table's near
/// edge, away from the robot, which stands where it usually does; sideways from the table's middle.
struct LayoutRegion {
  /// What an arm takes straight from above lies within a circle about the point below its shoulder.
  /// Measured at tool heights from 0.08 to 0.25 m, at any yaw: 0.736 to 0.75 m all around.
  double reach = 0.72;            ///< radius [m]
  double shoulder_x = 0.26;       ///< sideways, to either side [m]
  double shoulder_depth = -0.10;  ///< [m]
  double table_rim = 0.02;        ///< nothing stands nearer to the table's edges [m]
  /// The middles of things are no farther sideways, and between these depths [m].
  double most_x = 1.0, least_depth = 0.0, most_depth = 1.0;

  /// The strip to build in, straight before the robot, as wide as the letters U and M with a finger
  /// on each side; without width: none.
  double strip_half_width = 0.58;              ///< [m]
  double strip_near = 0.34, strip_far = 0.51;  ///< depths [m]

  Footprint StripOn(const scene::TableSpec& table) const;
  /// True when the robot reaches a thing whose middle is at `center` in the world [m].
  bool Reaches(const scene::TableSpec& table, const Vector2& center) const;
  /// Whether the robot reaches the middle of a thing with this footprint, its eye sees all of it,
  /// up to its top, and all of it is on the table. Things in the strip are within.
  bool Holds(const scene::TableSpec& table, const Footprint& footprint, double top) const;
};

}  // namespace smile::layout
