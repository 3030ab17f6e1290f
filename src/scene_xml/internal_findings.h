#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"

namespace smile::scene_xml {

/// Collects the diagnostics of one file. It takes a limited number of them, so that a file with a
/// million faults does not become a million messages.
class Findings {
 public:
  Findings(std::string file, int max_count) : file_(std::move(file)), max_count_(max_count) {}

  /// @param element  as it is shown between angle brackets; may be empty.
  void Add(int line, std::string element, std::string message) {
    if (is_full()) {
      has_dropped_ = true;
    } else {
      diagnostics_.push_back({file_, line, std::move(element), std::move(message)});
    }
  }

  /// Then it is not worth the time to word another one.
  bool is_full() const { return static_cast<int>(diagnostics_.size()) >= max_count_; }

  /// All of them, by line; those of one line in the order they were added.
  std::vector<Diagnostic> Take() {
    std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
    if (has_dropped_) {
      diagnostics_.push_back(
          {file_, diagnostics_.back().line, "",
           "found more faults than the " + std::to_string(max_count_) + " listed, expected none"});
    }
    return std::move(diagnostics_);
  }

 private:
  std::string file_;
  int max_count_;
  bool has_dropped_ = false;
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace smile::scene_xml
