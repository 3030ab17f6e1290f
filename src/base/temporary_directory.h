#pragma once

#include <filesystem>

namespace smile {

/// Temporary directory of this process, removed with its content on destruction.
class TemporaryDirectory {
 public:
  /// @throws std::runtime_error with path and reason if it cannot be made.
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace smile
