#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace smile {

/// The whole file as text.
/// @throws InputError when there is no such file, it is no plain file or larger than `max_bytes`;
///         std::runtime_error with path and reason when the machine does not let us read it.
std::string ReadFile(const std::filesystem::path& path, std::size_t max_bytes);

/// Writes a small file whole: to a neighbour first, then renamed over, so that a reader or a crash
/// sees the old file or the new one, never half of it.
/// @throws std::runtime_error naming the path and the reason.
void WriteFile(const std::filesystem::path& path, std::string_view text);

/// Creates a directory and its parents.
/// @throws std::runtime_error naming the path and the reason.
void MakeDirectories(const std::filesystem::path& path);

/// True when a path leads to something in a folder or below it, or to the folder itself, wherever
/// links and `..` on both lead. False when one of them is not there.
bool IsWithin(const std::filesystem::path& path, const std::filesystem::path& folder);

/// A file that ships with SMILE (`robots/baxter.urdf`, `scenes/…`, `matlab/…`): looked for under
/// the environment variable SMILE_DATA_DIR, beside the program in `../share/smile`, and in the
/// source tree the program was built from.
/// @throws std::runtime_error naming all places looked at.
std::filesystem::path DataFile(std::string_view relative_path);

}  // namespace smile
