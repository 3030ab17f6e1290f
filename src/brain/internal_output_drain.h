#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "process/unique_fd.h"

namespace smile::brain {

/// Reader of a program's output on a thread of its own, so that the program never blocks on a full
/// pipe.
///
/// Limits any amount of output: a line is cut after kMaxLineLetters, at most kMaxLinesPerSecond are
/// passed on (with a note on the number of dropped ones), and the last kLinesKept are kept.
class OutputDrain {
 public:
  static constexpr std::size_t kMaxLineLetters = 1000;
  static constexpr int kMaxLinesPerSecond = 200;
  static constexpr std::size_t kLinesKept = 20;

  /// @param pipe     non-blocking.
  /// @param on_line  called on the thread, line by line, without line ends; must not throw. May be
  ///                 empty.
  OutputDrain(process::UniqueFd pipe, std::function<void(std::string_view)> on_line);
  OutputDrain(const OutputDrain&) = delete;
  OutputDrain& operator=(const OutputDrain&) = delete;
  ~OutputDrain() { Finish(); }

  /// Reads the rest of the pipe and ends the thread. To be called after the program has ended.
  void Finish();

  std::vector<std::string> LastLines() const;

 private:
  void Run();
  /// @returns false at the end of the pipe.
  bool ReadAvailable(std::size_t max_bytes);
  void TakeText(std::string_view text);
  void EndLine();
  void HandOn(const std::string& line);
  void ReportSkippedLines();

  process::UniqueFd pipe_;
  process::UniqueFd wake_read_, wake_write_;
  std::function<void(std::string_view)> on_line_;

  std::string line_;  ///< the incomplete last line, cut
  std::chrono::steady_clock::time_point second_began_;
  int lines_this_second_ = 0;
  std::size_t num_skipped_lines_ = 0;

  mutable std::mutex mutex_;
  std::deque<std::string> last_lines_;  ///< guarded by mutex_

  std::thread thread_;
};

}  // namespace smile::brain
