#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace smile::experiment {

/// Log file of bounded size for the output of a program: keeps its beginning and its end.
class BoundedLog {
 public:
  static constexpr std::size_t kBeginBytes = 256 << 10, kEndBytes = 64 << 10;

  /// @throws std::runtime_error if it cannot be written.
  explicit BoundedLog(const std::filesystem::path& path);

  void Add(std::string_view text);
  /// Writes the end.
  void Finish();
  /// Returns the last line that is not blank, cleaned for a terminal; empty if there are no lines.
  std::string last_line() const;

 private:
  std::ofstream file_;
  std::size_t begin_bytes_ = 0;
  std::string end_;                  ///< of all that was printed
  std::size_t unwritten_bytes_ = 0;  ///< how much of it is not in the file yet
};

}  // namespace smile::experiment
