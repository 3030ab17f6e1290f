#include "app/console_reporter.h"

#include <cstdio>

#include "app/interrupt.h"

namespace smile::app {

ConsoleReporter::ConsoleReporter()
    : callbacks_{.is_cancelled = &IsInterrupted,
                 .on_progress = [this](const std::string& step, double done,
                                       double total) { Show(step, done, total); },
                 .on_message = [this](std::string_view message) { Print(message); }} {}

void ConsoleReporter::Clear() {
  const std::scoped_lock lock(mutex_);
  line_.reset();
  step_.clear();
}

void ConsoleReporter::Show(const std::string& step, double done, double total) {
  const std::scoped_lock lock(mutex_);
  if (step != step_) {
    line_.emplace(step);
    step_ = step;
  }
  if (line_) line_->Show(done, total);
}

void ConsoleReporter::Print(std::string_view message) {
  const std::scoped_lock lock(mutex_);
  if (line_) line_->Wipe();
  std::fprintf(stderr, "%.*s\n", static_cast<int>(message.size()), message.data());
}

}  // namespace smile::app
