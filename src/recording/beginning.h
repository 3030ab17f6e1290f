#pragma once

#include <filesystem>

#include "recording/append_file.h"

namespace smile::recording {

/// Mark of a recording that is being created: a locked file in its directory, which exists from
/// before anything else is written there until the recording can be opened. An unlocked mark means
/// that the program was killed in between.
class BeginningMark {
 public:
  /// Makes the directory and the mark, replacing an abandoned beginning.
  /// @throws std::runtime_error if they cannot be written.
  explicit BeginningMark(const std::filesystem::path& directory);

  /// Removes the mark, once the recording can be opened.
  void Remove();

 private:
  std::filesystem::path path_;
  AppendFile lock_;
};

/// True if a directory contains only an abandoned beginning.
bool IsAbandoned(const std::filesystem::path& directory);

}  // namespace smile::recording
