#pragma once

#include <chrono>
#include <string>

namespace smile::app {

/// One line on a terminal's stderr that tells how far long work is; silent where nobody watches.
class ProgressLine {
 public:
  /// @param label  what is being done; empty for silence.
  explicit ProgressLine(std::string label);
  /// Wipes the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @param total  in the same unit; 0 when unknown.
  void Show(double done, double total, const char* unit = "s");
  /// In words.
  void Say(const std::string& words);
  /// Wipes the line, for other messages.
  void Wipe();

 private:
  /// False of what nobody would see: there is no terminal, or it was told a moment ago.
  bool IsDue();

  std::string label_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace smile::app
