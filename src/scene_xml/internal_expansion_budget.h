#pragma once

#include <cstddef>
#include <string>

#include "scene_xml/internal_findings.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

/// Budget of template expansion: a file of a kilobyte can request billions of elements. When it is
/// spent, expansion ends.
class ExpansionBudget {
 public:
  ExpansionBudget(const SceneLimits& limits, Findings* findings)
      : limits_(limits), findings_(*findings) {}

  /// Returns false if the budget is exceeded; the first time, with a finding at `place`.
  bool Spend(int elements, std::size_t bytes, const SourceLocation& place) {
    if (is_spent_) return false;
    num_elements_ += elements;
    num_bytes_ += bytes;
    if (num_elements_ > limits_.max_elements) {
      Refuse("elements", std::to_string(limits_.max_elements), place);
    } else if (num_bytes_ > limits_.max_file_bytes) {
      Refuse("bytes", std::to_string(limits_.max_file_bytes), place);
    }
    return !is_spent_;
  }

  bool is_spent() const { return is_spent_; }
  std::size_t bytes_left() const { return is_spent_ ? 0 : limits_.max_file_bytes - num_bytes_; }

 private:
  void Refuse(const std::string& what, const std::string& limit, const SourceLocation& place) {
    is_spent_ = true;
    findings_.Add(place, "",
                  "found more than " + limit + " " + what + " out of templates, expected fewer");
  }

  const SceneLimits& limits_;
  Findings& findings_;
  long long num_elements_ = 0;
  std::size_t num_bytes_ = 0;
  bool is_spent_ = false;
};

}  // namespace smile::scene_xml
