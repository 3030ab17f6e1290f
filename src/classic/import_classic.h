#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene_spec.h"

namespace smile::classic {

struct ImportOptions {
  /// The scene it was made with, its objects called the same; those the recording lacks are absent.
  /// nullopt: stand-ins, see MakeStandIns().
  std::optional<scene::SceneSpec> scene;
  std::string title, notes;
};

struct ImportReport {
  std::uint64_t frames = 0;
  std::size_t segments = 0, objects = 0, pictures = 0;
  std::vector<std::string> remarks;  ///< what could not be kept, in words
};

/// Makes a recording of a classic one, to be looked at: texts and pictures as they are, and a trace
/// of what they tell (docs/importing.md). Objects stay where they were seen last until they are
/// seen elsewhere.
/// @throws InputError if something is wrong with the classic recording, the scene is not the one it
///         was made with, or `directory` exists and is not empty. Nothing is written then.
/// @throws std::runtime_error with path and reason if something cannot be written.
ImportReport ImportClassic(const std::filesystem::path& classic,
                           const std::filesystem::path& directory, const ImportOptions& options);

}  // namespace smile::classic
