#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace smile::library {

/// Returns a ZIP file of all regular files below a directory, in their present state, sorted by
/// name, under the directory's own name. Links are skipped.
/// @throws std::runtime_error with path and reason if they exceed `max_bytes` in total, or one
///         cannot be read.
std::string Zipped(const std::filesystem::path& directory, std::uint64_t max_bytes);

}  // namespace smile::library
