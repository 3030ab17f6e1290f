#pragma once

#include <string>

#include "robot/robot_model.h"

namespace smile::robot {

/// Adds what Baxter looks like to the pictures a robot's description has: shells, screen and
/// springs made by rule (see src/mesh/modeling.h), and a face for each mood. Both arms share their
/// meshes, and so do all robots of one program.
///
/// Links are found by Baxter's names.
///
/// @throws std::invalid_argument naming the link that is missing.
void AddBaxterLook(RobotModel* model);

/// Adds what the gripper of the 2015 program looks like: palm and two fingers, within the boxes
/// that collide.
///
/// @param prefix  before the names of its links: `left_`.
/// @throws std::invalid_argument naming the link that is missing.
void AddClassicGripperLook(const std::string& prefix, RobotModel* model);

}  // namespace smile::robot
