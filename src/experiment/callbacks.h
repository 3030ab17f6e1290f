#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "recording/progress.h"

namespace smile::experiment {

/// Functions by which long work reports to its caller and learns that it is to end. Each may be
/// empty.
struct Callbacks {
  /// Polled between steps of the work. True ends the work early; everything recorded so far is
  /// kept.
  std::function<bool()> is_cancelled;
  /// Reports how far the current step is [s]; `total` is 0 when unknown.
  std::function<void(const std::string& step, double done, double total)> on_progress;
  /// Receives a message for people, without the line end. Called from any thread.
  std::function<void(std::string_view message)> on_message;

  bool IsCancelled() const { return is_cancelled && is_cancelled(); }
  void Report(const std::string& step, double done, double total) const {
    if (on_progress) on_progress(step, done, total);
  }
  void Say(std::string_view message) const {
    if (on_message) on_message(message);
  }
  /// The same for work in lower rooms, as one step. The result refers to this object.
  recording::Progress ProgressOf(std::string step) const {
    return [this, name = std::move(step)](double done, double total) {
      Report(name, done, total);
      return !IsCancelled();
    };
  }
};

}  // namespace smile::experiment
