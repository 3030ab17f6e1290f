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
  /// Scene of the recording, with objects of the same ids; those that the recording lacks are
  /// absent. nullopt: placeholder objects, see MakePlaceholders().
  std::optional<scene::SceneSpec> scene;
  std::string title, notes;
};

struct ImportReport {
  std::uint64_t frames = 0;
  std::size_t segments = 0, objects = 0, pictures = 0;
  std::vector<std::string> remarks;  ///< facts that could not be kept, for people
};

/// Converts a classic recording for viewing: copies texts and pictures and derives a trace from
/// them (docs/importing.md). Objects stay where they were last seen until they are seen elsewhere.
/// @throws InputError if something is wrong with the classic recording, the scene is not the one it
///         was made with, or `directory` exists and is not empty. Nothing is written then.
/// @throws std::runtime_error with path and reason if something cannot be written.
ImportReport ImportClassic(const std::filesystem::path& classic,
                           const std::filesystem::path& directory, const ImportOptions& options);

}  // namespace smile::classic
