#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace smile::studio {

/// A line that a robot program printed, and the place in a program it tells of.
struct ConsoleLine {
  std::string text;
  std::string file;  ///< empty: none
  int line = 0;

  bool operator==(const ConsoleLine&) const = default;
};

/// Finds the place: `wave/waveCallback.m:12`, `File "wave.py", line 12`, or, as Octave has it,
/// `waveCallback at line 12`.
ConsoleLine ParseConsoleLine(std::string_view text);

/// What a robot program prints, from the thread that reads it to the one that tells it. Of a flood
/// only the newest lines are kept.
class Console {
 public:
  static constexpr std::size_t kMaxLines = 500, kMaxLineBytes = 2'000;

  /// From any thread.
  void Write(std::string_view line);
  std::vector<ConsoleLine> Take();

 private:
  std::mutex mutex_;
  std::vector<ConsoleLine> lines_;
  std::size_t num_lost_ = 0;
};

}  // namespace smile::studio
