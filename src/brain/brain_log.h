#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace smile::brain {

/// `brain.log` in a recording: the output of the brain, and why it failed; or another file for
/// what it says. The file is created with its first line and does not grow beyond kMaxBytes. If the
/// log cannot be written, it is silently abandoned: no run ends because of it.
class BrainLog {
 public:
  static constexpr std::uintmax_t kMaxBytes = 10'000'000;

  /// @param directory  of the recording; empty for no log. Need not exist before the first line.
  explicit BrainLog(const std::filesystem::path& directory, const char* file = "brain.log");

  void Write(std::string_view line);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void Open();

  std::filesystem::path path_;  ///< empty: nothing more is written
  std::unique_ptr<std::FILE, Close> file_;
  std::uintmax_t bytes_ = 0;
};

}  // namespace smile::brain
