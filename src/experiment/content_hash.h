#pragma once

#include <filesystem>
#include <string>

#include "robot/urdf_reader.h"
#include "scene/scene_spec.h"

namespace smile::experiment {

// Content hashes of the inputs of results, as 16 hexadecimal digits.

/// Hash of a file, or of all files in a folder and below it, with their names.
/// @throws std::runtime_error if one cannot be read, or the folder is too large.
std::string ContentOf(const std::filesystem::path& path);

/// Hash of a brain: of a folder or a file, and for a Python file also of the others beside it and
/// of the packages there, which it may import. The constants of the shipped learners are in it,
/// too.
std::string ContentOfBrain(const std::filesystem::path& brain);

std::string ContentOf(const scene::SceneSpec& scene);
std::string ContentOf(const std::vector<robot::RobotFile>& files);

}  // namespace smile::experiment
