#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace smile::library {

/// A ZIP file of all plain files below a directory, as they are now, in the order of their names,
/// under the directory's own name. Links are left out.
/// @throws std::runtime_error with path and reason if they are more than so many bytes, or one
///         cannot be read.
std::string Zipped(const std::filesystem::path& directory, std::uint64_t max_bytes);

}  // namespace smile::library
