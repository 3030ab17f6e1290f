#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace smile::bench {

/// Temporary folder, removed with this object.
class ScratchFolder {
 public:
  ScratchFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("smile_bench_" + std::to_string(getpid()) + "_" + std::to_string(num_made_++))) {
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  inline static int num_made_ = 0;
  std::filesystem::path path_;
};

}  // namespace smile::bench
