#pragma once

#include <functional>
#include <memory>

#include "layout/footprint.h"
#include "layout/reach_map.h"
#include "math/rigid_transform.h"
#include "scene/scene_spec.h"

namespace smile::layout {

/// Region of the table for seeded layouts: within the robot's reach, in view of its eye, and
/// outside its building area (docs/experiments.md). The default is Baxter's, as measured;
/// experiment:: RegionOf() computes that of another robot. Depths count from the table's near edge
/// away from the robot, which stands at its default place; sideways distances count from the
/// table's middle.
struct LayoutRegion {
  /// Places that the robot reaches, less `reach_margin` [m]; null: the circles below.
  std::shared_ptr<const ReachMap> reach_map;
  double reach_margin = 0;
  /// Pose of the robot's eye C: from the middle of the table's near edge, x right, y away from the
  /// robot, z up. The default is Baxter's, which is also that of robots without an eye.
  RigidTransform X_EC = StandardEye();
  /// Returns true if the robot, as it stands at the start, touches an object with this footprint
  /// and height [m]. The footprint is counted from the middle of the table's near edge. Null: it
  /// touches none.
  std::function<bool(const Footprint&, double top)> touches_at_start;

  /// An arm grasps vertically within a circle about the point below its shoulder. Measured at tool
  /// heights from 0.08 to 0.25 m, at any yaw: 0.736 to 0.75 m all around.
  double reach = 0.72;            ///< radius [m]
  double shoulder_x = 0.26;       ///< sideways, to either side [m]
  double shoulder_depth = -0.10;  ///< [m]
  double table_rim = 0.02;        ///< least distance from the table's edges [m]
  /// Bounds of the centers of objects: sideways, and in depth [m].
  double most_x = 1.0, least_depth = 0.0, most_depth = 1.0;

  /// Strip to build in, in front of the robot, as wide as the letters U and M with a finger on each
  /// side; width 0: no strip.
  double strip_half_width = 0.58;              ///< [m]
  double strip_near = 0.34, strip_far = 0.51;  ///< depths [m]

  static RigidTransform StandardEye();
  /// Returns the region whose reach ends earlier.
  LayoutRegion ShrunkBy(double rim) const;
  /// Returns the strip on a table.
  Footprint StripOn(const scene::TableSpec& table) const;
  /// Returns true if the robot reaches an object whose center is at `center` in the world [m].
  bool Reaches(const scene::TableSpec& table, const Vector2& center) const;
  /// Returns true if the robot reaches the center of an object with this footprint, its eye sees
  /// all of it, up to its top, all of it is on the table, and the robot does not touch it at the
  /// start. The strip does not matter.
  bool Holds(const scene::TableSpec& table, const Footprint& footprint, double top) const;
};

}  // namespace smile::layout
