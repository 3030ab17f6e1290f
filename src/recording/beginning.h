#pragma once

#include <filesystem>

#include "recording/append_file.h"

namespace smile::recording {

/// Mark of a recording that is being begun: a locked file in its directory, from before anything
/// else is written there until the recording can be opened. A mark that is not locked tells that
/// the program was killed in between.
class BeginningMark {
 public:
  /// Makes the directory and the mark, in place of a beginning that was abandoned.
  /// @throws std::runtime_error if they cannot be written.
  explicit BeginningMark(const std::filesystem::path& directory);

  /// Removes the mark: the recording has begun.
  void Remove();

 private:
  std::filesystem::path path_;
  AppendFile lock_;
};

/// True when a directory holds nothing but a beginning that was abandoned.
bool IsAbandoned(const std::filesystem::path& directory);

}  // namespace smile::recording
