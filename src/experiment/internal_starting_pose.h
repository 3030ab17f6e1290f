#pragma once

#include <vector>

#include "layout/footprint.h"
#include "robot/robot_model.h"
#include "scene/bounds.h"
#include "scene/solid.h"

namespace smile::experiment {

/// A robot as it stands at the start of a run, before a table whose near edge is at y = 0.
class StartingPose {
 public:
  StartingPose(const robot::RobotModel& model, const RigidTransform& X_WBase);

  /// Returns true if a box on the table comes closer than 2 mm to the robot.
  /// @param top  height of the box [m].
  bool Touches(const layout::Footprint& footprint, double top) const;

 private:
  /// Convex piece of a link.
  struct Piece {
    scene::Solid solid;  ///< Solid::X_BS is X_WS
    scene::Bounds bounds;
  };
  std::vector<Piece> pieces_;
};

}  // namespace smile::experiment
