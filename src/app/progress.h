#pragma once

#include <chrono>
#include <string>

namespace smile::app {

/// Progress line on stderr if it is a terminal; silent otherwise.
class ProgressLine {
 public:
  /// @param label  name of the work; empty for silence.
  explicit ProgressLine(std::string label);
  /// Erases the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @param total  in the same unit; 0 if unknown.
  void Show(double done, double total, const char* unit = "s");
  /// Shows a status text.
  void Say(const std::string& words);
  /// Erases the line, for other messages.
  void Wipe();

 private:
  /// Returns false if there is no terminal, or if the line was updated a moment ago.
  bool IsDue();

  std::string label_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace smile::app
