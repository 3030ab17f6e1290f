#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "scene_xml/internal_sources.h"

namespace smile::scene_xml {

/// Collector of the diagnostics of one scene. The number is limited, so that a file with a million
/// faults does not become a million messages.
class Findings {
 public:
  Findings(std::string main_file, int max_count)
      : sources_(std::move(main_file)), max_count_(max_count) {}

  /// Adds a finding. A fault of a template counts once, however often the template is used.
  ///
  /// @param element  as it is shown between angle brackets; may be empty.
  void Add(const SourceLocation& place, std::string element, std::string message);

  /// True if further findings are dropped; then there is no need to compose their messages.
  bool is_full() const { return static_cast<int>(findings_.size()) >= max_count_; }
  bool is_empty() const { return findings_.empty(); }

  /// Returns all diagnostics: files in the order they were read, by line; those of one line in the
  /// order they were added.
  std::vector<Diagnostic> Take();

  Sources& sources() { return sources_; }

 private:
  struct Finding {
    int file;
    Diagnostic diagnostic;
  };

  Sources sources_;
  int max_count_;
  bool has_dropped_ = false;
  std::vector<Finding> findings_;
  std::set<std::string> in_templates_;  // findings inside templates
};

}  // namespace smile::scene_xml
