#include "app/progress.h"

#include <unistd.h>

#include <cstdio>

namespace smile::app {

ProgressLine::ProgressLine(std::string label) : label_(std::move(label)) {
  if (isatty(STDERR_FILENO) == 0) label_.clear();
}

ProgressLine::~ProgressLine() {
  if (is_shown_) std::fprintf(stderr, "\r\033[K");
}

void ProgressLine::Show(double done, double total, const char* unit) {
  if (label_.empty()) return;
  const auto now = std::chrono::steady_clock::now();
  if (is_shown_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  is_shown_ = true;
  if (total > 0) {
    std::fprintf(stderr, "\r%s: %.1f of %.1f %s\033[K", label_.c_str(), done, total, unit);
  } else {
    std::fprintf(stderr, "\r%s: %.1f %s\033[K", label_.c_str(), done, unit);
  }
  std::fflush(stderr);
}

}  // namespace smile::app
