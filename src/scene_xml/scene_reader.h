#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "scene/scene_spec.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

struct SceneReaderOptions {
  /// Folders to search for included files and meshes, after the folder of the file that refers to
  /// them.
  std::vector<std::filesystem::path> search_roots;
  SceneLimits limits;
};

/// Scene, or all diagnostics.
struct SceneReading {
  std::optional<scene::SceneSpec> scene;  ///< empty if there is any diagnostic
  /// In the order of the files, as they were read, and of their lines, which start at 1.
  std::vector<Diagnostic> diagnostics;
  /// Place of each object in the files, for people: `parts/letters.xml:7 (in the instance at
  /// letters.xml:6)`.
  std::vector<std::string> origins;
};

/// Reads a scene file (docs/scene-format.md), looking at all of it: five faults, five diagnostics.
/// The scene is named after the file, without folder and extension. A file that cannot be opened is
/// a diagnostic too.
///
/// Included files and meshes are read only from the folder of the scene, what is below it, and the
/// same of `search_roots`; a link that leads elsewhere is not followed.
SceneReading ReadScene(const std::filesystem::path& path, const SceneReaderOptions& options = {});

/// Reads a scene from a text; `file_name` is its name in diagnostics and names the scene. A text
/// has no folder: files that it refers to are found in `search_roots` only.
SceneReading ReadSceneText(std::string_view xml, const std::string& file_name,
                           const SceneReaderOptions& options = {});

/// Returns the scene of a file, for callers that cannot continue without it.
/// @throws InputError with all diagnostics.
scene::SceneSpec LoadScene(const std::filesystem::path& path,
                           const SceneReaderOptions& options = {});

}  // namespace smile::scene_xml
