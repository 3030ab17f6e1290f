#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace smile {

/// Returns the whole file as text.
/// @throws InputError if the file does not exist, is not a regular file or is larger than
///         `max_bytes`; std::runtime_error with path and reason if it cannot be read.
std::string ReadFile(const std::filesystem::path& path, std::size_t max_bytes);

/// Writes a small file atomically: to a temporary neighbor first, then renamed, so that a reader or
/// a crash sees the old file or the new one, never a part of it.
/// @throws std::runtime_error naming the path and the reason.
void WriteFile(const std::filesystem::path& path, std::string_view text);

/// Creates a directory and its parents.
/// @throws std::runtime_error naming the path and the reason.
void MakeDirectories(const std::filesystem::path& path);

/// Returns true if a path, after all links and `..` are resolved, lies in a folder or below it, or
/// is the folder itself. False if one of them does not exist.
bool IsWithin(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Returns a file that ships with SMILE (`robots/baxter.urdf`, `scenes/…`, `matlab/…`): searched
/// under the environment variable SMILE_DATA_DIR, beside the program in `../share/smile`, in the
/// Python package in `share/smile`, and in the source tree from which the program was built.
/// @throws std::runtime_error with all places searched.
std::filesystem::path DataFile(std::string_view relative_path);

}  // namespace smile
