#pragma once

#include <string>
#include <string_view>

#include "motion/joint_trajectory.h"

namespace smile::fuzz {

/// What is wrong with how we take this text as a joint trajectory, in words; empty when all is
/// well.
///
/// What is refused has a reason and a place. What is read comes back from its own files the same.
std::string FaultWithTrajectory(std::string_view text);

/// Reads JSON if the text begins with a brace, else a table.
/// @throws InputError as motion::ReadTrajectory() does.
motion::JointTrajectory ReadTrajectoryText(std::string_view text);

}  // namespace smile::fuzz
