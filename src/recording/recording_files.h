#pragma once

#include <filesystem>

#include "model/model.h"

namespace smile::recording {

/// Checks that a recording can be written to a directory.
/// @throws InputError if the directory is not empty, unless it contains an abandoned beginning; or
///         if it lies within another recording.
void RequireNewDirectory(const std::filesystem::path& directory);

/// Makes the directory of a recording and writes scene, meshes and robot into it.
void WriteWorld(const std::filesystem::path& directory, const model::Model& model);

}  // namespace smile::recording
