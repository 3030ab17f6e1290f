#pragma once

#include <filesystem>

#include "scene/scene_spec.h"

namespace smile::recording {

/// Writes a self-contained scene file, and its meshes into a folder beside it.
/// @throws std::runtime_error if a file cannot be written.
void WriteSceneFiles(const scene::SceneSpec& scene, const std::filesystem::path& file);

}  // namespace smile::recording
