#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace smile {

/// State of a path itself, without following links; zeros if it does not exist.
struct FileState {
  bool is_directory = false, is_file = false;
  std::uint64_t number = 0, size = 0;
  std::int64_t changed = 0;  ///< [ns since 1970]

  bool operator==(const FileState&) const = default;
};
FileState StateOf(const std::filesystem::path& path);

/// Returns a text that changes whenever the file changes.
std::string StampOf(const std::filesystem::path& path);

}  // namespace smile
