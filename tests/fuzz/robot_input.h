#pragma once

#include <string>
#include <string_view>

#include "robot/urdf_reader.h"

namespace smile::fuzz {

/// Reads a robot from the text of a URDF; what follows the line `=====` is its side file. Whatever
/// STL file it names is there, a small one, and whatever URDF a gripper is made of.
/// @throws InputError when it is no robot.
robot::RobotReading ReadHostileRobot(std::string_view text);

/// What is wrong with how we take these texts, in words; empty when all is well.
///
/// Invalid texts are refused with a reason. A robot has numbers that are some, masses, indexes
/// that exist, stands within its limits, and is the same again from the files that are kept of it.
std::string FaultWithRobot(std::string_view text);

}  // namespace smile::fuzz
