#include "app/progress.h"

#include <unistd.h>

#include <cstdio>

namespace smile::app {

ProgressLine::ProgressLine(std::string label) : label_(std::move(label)) {
  if (isatty(STDERR_FILENO) == 0) label_.clear();
}

ProgressLine::~ProgressLine() { Wipe(); }

void ProgressLine::Wipe() {
  if (is_shown_) std::fprintf(stderr, "\r\033[K");
  is_shown_ = false;
}

bool ProgressLine::IsDue() {
  if (label_.empty()) return false;
  const auto now = std::chrono::steady_clock::now();
  if (is_shown_ && now - last_ < std::chrono::milliseconds(100)) return false;
  last_ = now;
  is_shown_ = true;
  return true;
}

void ProgressLine::Show(double done, double total, const char* unit) {
  if (!IsDue()) return;
  if (total > 0) {
    std::fprintf(stderr, "\r%s: %.1f of %.1f %s\033[K", label_.c_str(), done, total, unit);
  } else {
    std::fprintf(stderr, "\r%s: %.1f %s\033[K", label_.c_str(), done, unit);
  }
  std::fflush(stderr);
}

void ProgressLine::Say(const std::string& words) {
  if (!IsDue()) return;
  std::fprintf(stderr, "\r%s: %s\033[K", label_.c_str(), words.c_str());
  std::fflush(stderr);
}

}  // namespace smile::app
