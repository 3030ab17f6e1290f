#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

/// Amount of a scene read so far.
struct ReadCounts {
  std::size_t num_bytes = 0;
  int num_elements = 0;
};

/// Replaces each `include` of the root by the content of its file: each file once, with the files
/// that it includes in turn; circles end.
///
/// A file is looked for beside the one that includes it, then in the search roots. It must lie in
/// the folder of the scene or a search root, or below, after all links have been followed.
///
/// @param main_file     nullptr for a text without a file.
/// @param search_roots  see SceneReaderOptions.
/// @param counts        of the main file.
/// @returns true if every file was found and valid; otherwise the reasons are findings.
bool ResolveIncludes(const std::filesystem::path* main_file,
                     const std::vector<std::filesystem::path>& search_roots,
                     const SceneLimits& limits, const ReadCounts& counts, SceneElement* root,
                     ReadingContext* reading);

}  // namespace smile::scene_xml
