#pragma once

#include <filesystem>
#include <string_view>

#include "process/unique_fd.h"

namespace smile::experiment {

/// Exclusive lock of a folder, held for the lifetime of this object, so that no two processes
/// write the same results. Child processes do not inherit it. It leaves nothing behind, in whatever
/// way the process ends.
class FolderLock {
 public:
  /// Makes the folder if it is missing.
  /// @param work  what holds such a lock, for the message.
  /// @throws std::runtime_error if the lock is held already, or the folder cannot be opened.
  explicit FolderLock(const std::filesystem::path& folder, std::string_view work = "evaluation");

 private:
  process::UniqueFd folder_;
};

}  // namespace smile::experiment
