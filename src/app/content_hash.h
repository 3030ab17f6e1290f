#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "robot/urdf_reader.h"
#include "scene/scene_spec.h"

namespace smile::app {

// What results depend on, in 16 hexadecimal digits: when it is another, so is the text.

/// Of a file, or of all files in a folder and below it, with their names.
/// @throws std::runtime_error if one cannot be read, or there is too much to look at.
std::string ContentOf(const std::filesystem::path& path);

/// Of a robot program: a folder; or a file, and for a Python file the others beside it that it may
/// import.
std::string ContentOfBrain(const std::filesystem::path& brain);

std::string ContentOf(const scene::SceneSpec& scene);
std::string ContentOf(const std::vector<robot::RobotFile>& files);

}  // namespace smile::app
