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
  /// Where included files and meshes are looked for after the folder of the file that names them.
  std::vector<std::filesystem::path> search_roots;
  SceneLimits limits;
};

/// A scene, or everything that is wrong with it.
struct SceneReading {
  std::optional<scene::SceneSpec> scene;  ///< empty when there is any diagnostic
  /// In the order of the files, as they were read, and of their lines, which start at 1.
  std::vector<Diagnostic> diagnostics;
  /// Where each object of the scene was written, for people: `parts/letters.xml:7 (in the instance
  /// at letters.xml:6)`.
  std::vector<std::string> origins;
};

/// Reads a scene file (docs/scene-format.md), looking at all of it: five faults, five diagnostics.
/// The scene is named after the file, without folder and extension. A file that cannot be opened is
/// a diagnostic too.
///
/// Included files and meshes are read only from the folder of the scene, what is below it, and the
/// same of `search_roots`; a link that leads elsewhere is not followed.
SceneReading ReadScene(const std::filesystem::path& path, const SceneReaderOptions& options = {});

/// The same for a text at hand; `file_name` names it in diagnostics and names the scene. A text
/// lies in no folder: the files it names are looked for in `search_roots` alone.
SceneReading ReadSceneText(std::string_view xml, const std::string& file_name,
                           const SceneReaderOptions& options = {});

/// For callers who cannot go on without the scene.
/// @throws InputError with all diagnostics.
scene::SceneSpec LoadScene(const std::filesystem::path& path,
                           const SceneReaderOptions& options = {});

}  // namespace smile::scene_xml
