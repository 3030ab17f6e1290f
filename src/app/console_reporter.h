#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "app/progress.h"
#include "experiment/callbacks.h"

namespace smile::app {

/// Reporter of long work on stderr: a progress line for each step on a terminal, messages as lines.
/// Cancels the work when the user interrupts the program.
class ConsoleReporter {
 public:
  ConsoleReporter();
  ConsoleReporter(const ConsoleReporter&) = delete;
  ConsoleReporter& operator=(const ConsoleReporter&) = delete;

  /// Returns callbacks that refer to this object.
  const experiment::Callbacks& callbacks() const { return callbacks_; }
  /// Erases the progress line, before results are printed.
  void Clear();

 private:
  void Show(const std::string& step, double done, double total);
  void Print(std::string_view message);

  std::mutex mutex_;  ///< guards the rest: messages come from several threads
  std::string step_;
  std::optional<ProgressLine> line_;
  experiment::Callbacks callbacks_;
};

}  // namespace smile::app
