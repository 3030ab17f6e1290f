#pragma once

#include <string>
#include <vector>

#include "robot/robot_model.h"
#include "robot/urdf_reader.h"

namespace smile::model {

/// Options of a robot's body.
struct RobotBodyOptions {
  /// The arms move as commanded, whatever is in their way, see scene::ArticulationSpec. Costs less
  /// than a dynamic body.
  bool is_kinematic = false;
  /// Grippers hold by friction instead of attaching objects. Not for a kinematic robot, whose
  /// fingers would press with any force.
  bool grasps_by_friction = false;

  bool operator==(const RobotBodyOptions&) const = default;
};

/// A robot and its place at a table.
struct RobotPlacement {
  robot::RobotModel model;
  std::string gripper;                  ///< as in robot::RobotReading
  std::vector<robot::RobotFile> files;  ///< its files; without them it cannot be recorded
  double gap = 0.20;                    ///< from its base to the table's near edge [m]
  double height = 0.20;                 ///< of its base above the table top [m]
  RobotBodyOptions body;
};

/// Returns the base frame of a robot (x forward, z up) that stands at the near edge of a table and
/// faces it.
RigidTransform RobotBasePose(const scene::TableSpec& table, double gap, double height);

}  // namespace smile::model
