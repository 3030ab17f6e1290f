#pragma once

#include <string>
#include <vector>

#include "robot/robot_model.h"
#include "robot/urdf_reader.h"

namespace smile::model {

/// The kind of body a robot has.
struct RobotBodyOptions {
  /// Nothing stops its arms, see scene::ArticulationSpec. Costs less than one that is stopped.
  bool is_kinematic = false;
  /// Grippers attach nothing to themselves: fingers press, and friction holds. Not of a kinematic
  /// robot, whose fingers would press with any force.
  bool grasps_by_friction = false;

  bool operator==(const RobotBodyOptions&) const = default;
};

/// A robot, and where it stands at a table.
struct RobotPlacement {
  robot::RobotModel model;
  std::string gripper;                  ///< as robot::RobotReading has it
  std::vector<robot::RobotFile> files;  ///< it was read from; without them it cannot be recorded
  double gap = 0.20;                    ///< from its base to the table's near edge [m]
  double height = 0.20;                 ///< of its base above the table top [m]
  RobotBodyOptions body;
};

/// Base frame of a robot (x forward, z up) that stands at the near edge of a table and faces it.
RigidTransform RobotBasePose(const scene::TableSpec& table, double gap, double height);

}  // namespace smile::model
