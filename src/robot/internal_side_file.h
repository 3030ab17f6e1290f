#pragma once

#include <filesystem>

#include "robot/robot_model.h"

namespace smile::robot::internal {

/// Adds to a robot what a URDF cannot say: arms, grippers, head, links that may touch, poses, the
/// pose to start in, and a look authored here. docs/robot.md describes the file.
/// @throws InputError naming the place inside the file, as `arms/left/joints`.
/// @throws std::runtime_error when the file cannot be read.
void ReadSideFile(const std::filesystem::path& path, RobotModel* model);

}  // namespace smile::robot::internal
