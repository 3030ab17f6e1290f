#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace smile::studio {

/// Line printed by a brain, and the place in a program that it refers to.
struct ConsoleLine {
  std::string text;
  std::string file;  ///< empty: none
  int line = 0;

  bool operator==(const ConsoleLine&) const = default;
};

/// Parses a line and its place: `wave/waveCallback.m:12`, `File "wave.py", line 12`, or, from
/// Octave, `waveCallback at line 12`.
ConsoleLine ParseConsoleLine(std::string_view text);

/// Queue of lines printed by a brain, from the thread that reads them to the session's. If
/// there are too many, only the newest are kept.
class Console {
 public:
  static constexpr std::size_t kMaxLines = 500, kMaxLineBytes = 2'000;

  /// Adds a line; from any thread.
  void Write(std::string_view line);
  std::vector<ConsoleLine> Take();

 private:
  std::mutex mutex_;
  std::vector<ConsoleLine> lines_;
  std::size_t num_lost_ = 0;
};

}  // namespace smile::studio
