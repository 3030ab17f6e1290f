#pragma once

#include <filesystem>

#include "model/model.h"

namespace smile::recording {

/// @throws InputError if there is something where a recording is to be written, unless it is a
///         beginning that was abandoned; or if there is another recording around it.
void RequireNewDirectory(const std::filesystem::path& directory);

/// Makes the directory of a recording, with scene, meshes and robot.
void WriteWorld(const std::filesystem::path& directory, const model::Model& model);

}  // namespace smile::recording
