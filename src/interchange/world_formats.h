#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "interchange/exported_motion.h"

namespace smile::interchange {

/// Returns the names of all formats in which a world can be written.
std::vector<std::string_view> WorldFormatNames();

/// Demands a format in which objects move as in a recording; the others have one moment.
/// @throws std::invalid_argument naming the recording.
void RequireAnimated(std::string_view format, std::string_view recording);

/// Writes a scene to a file, and the files to which it refers into a folder beside it: those of
/// `a/tower.sdf` into `a/tower_meshes`.
/// @param format  one of WorldFormatNames().
/// @returns what has no counterpart in the format, in words.
/// @throws std::runtime_error naming the path and the reason.
std::vector<std::string> WriteScene(const ExportedScene& scene, std::string_view format,
                                    const std::filesystem::path& out);

}  // namespace smile::interchange
