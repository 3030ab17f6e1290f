#pragma once

#include <string>
#include <vector>

#include "catalog/robot_guess.h"
#include "model/robot_placement.h"

namespace smile::catalog {

/// Result of checking a robot, in lines for people.
struct RobotReport {
  std::vector<std::string> facts;     ///< arms, grippers, reach, poses
  std::vector<std::string> findings;  ///< what does not work; empty if all is well
};

/// Returns one line: arms, joints and grippers.
std::string SummaryOf(const robot::RobotModel& model);

/// Checks what reading a robot cannot see: whether links overlap in its poses, which links overlap
/// in most configurations, and how many places over the table each tool reaches pointing down.
/// @throws std::runtime_error if `progress` cancels.
RobotReport CheckRobot(const model::RobotPlacement& robot, const Progress& progress = nullptr);

}  // namespace smile::catalog
