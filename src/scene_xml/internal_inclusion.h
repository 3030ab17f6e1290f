#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

/// What has been read of a scene so far.
struct ReadCounts {
  std::size_t num_bytes = 0;
  int num_elements = 0;
};

/// Puts the content of other files in the place of each `include` of the root: each file once, the
/// files they include in turn, a circle of them without harm.
///
/// A file is looked for beside the one that includes it, then in the search roots. It must lie in
/// the folder of the scene or a search root, or below, after all links have been followed.
///
/// @param main_file     nullptr for a text without a file.
/// @param search_roots  as SceneReaderOptions has them.
/// @param counts        of the main file.
/// @returns whether every file was found whole; else the reasons are findings.
bool ResolveIncludes(const std::filesystem::path* main_file,
                     const std::vector<std::filesystem::path>& search_roots,
                     const SceneLimits& limits, const ReadCounts& counts, SceneElement* root,
                     Reading* reading);

}  // namespace smile::scene_xml
