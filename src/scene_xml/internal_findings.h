#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "scene_xml/internal_place.h"

namespace smile::scene_xml {

/// Collects the diagnostics of one scene. It takes a limited number of them, so that a file with a
/// million faults does not become a million messages.
class Findings {
 public:
  Findings(std::string main_file, int max_count)
      : sources_(std::move(main_file)), max_count_(max_count) {}

  /// A fault of a template is taken once, however often the template is used.
  ///
  /// @param element  as it is shown between angle brackets; may be empty.
  void Add(const Place& place, std::string element, std::string message);

  /// Then it is not worth the time to word another one.
  bool is_full() const { return static_cast<int>(findings_.size()) >= max_count_; }
  bool is_empty() const { return findings_.empty(); }

  /// All of them: files in the order they were read, by line, those of one line in the order they
  /// were added.
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
  std::set<std::string> in_templates_;  // what was said of places that instances brought
};

}  // namespace smile::scene_xml
