#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace smile::brain {

/// `brain.log` in a recording: what the robot program printed, and why it failed. The file appears
/// with its first line and does not grow beyond kMaxBytes. A log that cannot be written is given up
/// quietly: no run ends because of it.
class BrainLog {
 public:
  static constexpr std::uintmax_t kMaxBytes = 10'000'000;

  /// @param directory  of the recording; empty for no log. Need not exist before the first line.
  explicit BrainLog(const std::filesystem::path& directory);

  void Write(std::string_view line);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void Open();

  std::filesystem::path path_;  ///< empty when nothing more is to be written
  std::unique_ptr<std::FILE, Close> file_;
  std::uintmax_t bytes_ = 0;
};

}  // namespace smile::brain
