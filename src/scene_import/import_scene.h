#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "scene/scene_spec.h"

namespace smile::scene_import {

struct ImportSceneOptions {
  /// Folders to search for files that the model names, after its own folder.
  std::vector<std::filesystem::path> search_roots;
  /// Name of the body or shape that is the table; empty: the largest horizontal box whose name
  /// contains `table`, else the ground.
  std::string table;
};

/// Scene made of another simulator's model.
struct ImportedScene {
  scene::SceneSpec scene;
  /// What was left out or changed, with its place and the reason.
  std::vector<Diagnostic> remarks;
};

/// Returns the names of the formats that can be imported: mjcf, sdf, urdf.
std::vector<std::string_view> SceneFormatNames();

/// Reads a model of another simulator as a scene. The top of its table becomes the origin.
///
/// Included files and meshes are read only from the folder of the model, what is below it, and the
/// same of the search roots; nothing is fetched from a network.
///
/// @param format  one of SceneFormatNames().
/// @throws InputError with all faults; std::invalid_argument for another format.
ImportedScene ImportScene(const std::filesystem::path& path, std::string_view format,
                          const ImportSceneOptions& options = {});

/// Reads a model from a text; `name` is its name in messages and names the scene. A text has no
/// folder: files that it refers to are found in the search roots only.
ImportedScene ImportSceneText(std::string_view text, std::string_view format,
                              const std::string& name, const ImportSceneOptions& options = {});

}  // namespace smile::scene_import
