#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/urdf_reader.h"

namespace smile::brain {

/// Writes the files of a robot into a folder.
/// @returns the path of the first one, its URDF; empty without files.
/// @throws std::runtime_error if they cannot be written.
std::string WriteRobotFiles(const std::vector<robot::RobotFile>& files,
                            const std::filesystem::path& folder);

}  // namespace smile::brain
