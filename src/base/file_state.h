#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace smile {

/// What the system says of a path itself, not of what a link leads to; zeros where there is
/// nothing.
struct FileState {
  bool is_directory = false, is_file = false;
  std::uint64_t number = 0, size = 0;
  std::int64_t changed = 0;  ///< [ns since 1970]

  bool operator==(const FileState&) const = default;
};
FileState StateOf(const std::filesystem::path& path);

/// Differs after whatever changes a file.
std::string StampOf(const std::filesystem::path& path);

}  // namespace smile
