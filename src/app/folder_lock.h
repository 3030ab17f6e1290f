#pragma once

#include <filesystem>

#include "process/unique_fd.h"

namespace smile::app {

/// Keeps a folder for this process, as long as it lives: two that write the same results would
/// spoil them. Children do not inherit it. It leaves nothing behind, however the process ends.
class FolderLock {
 public:
  /// Makes the folder if need be.
  /// @throws std::runtime_error if another process keeps it, or the disk says no.
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  process::UniqueFd folder_;
};

}  // namespace smile::app
