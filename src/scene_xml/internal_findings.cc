#include "scene_xml/internal_findings.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace smile::scene_xml {

void Findings::Add(const SourceLocation& place, std::string element, std::string message) {
  // The rest is not even stored; Take() adds one line that says that there was more.
  if (is_full()) {
    has_dropped_ = true;
    return;
  }
  if (place.expansion >= 0) {
    // The same fault of a template recurs in each instance; only the first one is kept, with a note
    // on its instance.
    const std::string said = sources_.Address(place) + element + message;
    if (!in_templates_.insert(said).second) return;
    message += sources_.ExpansionNote(place);
  }
  findings_.push_back(
      {place.file, {sources_.FileOf(place), place.line, std::move(element), std::move(message)}});
}

std::vector<Diagnostic> Findings::Take() {
  const auto place_of = [](const Finding& finding) {
    // Findings arrive pass by pass: includes, templates, elements, references.
    return std::tuple(finding.file, finding.diagnostic.line);
  };
  // Sorted by file and line; stable, so that findings of one line keep their order.
  std::stable_sort(findings_.begin(), findings_.end(),
                   [&](const Finding& a, const Finding& b) { return place_of(a) < place_of(b); });
  std::vector<Diagnostic> diagnostics;
  for (Finding& finding : findings_) diagnostics.push_back(std::move(finding.diagnostic));
  if (has_dropped_) {
    diagnostics.push_back(
        {diagnostics.back().file, diagnostics.back().line, "",
         "found more errors than the " + std::to_string(max_count_) + " listed, expected none"});
  }
  return diagnostics;
}

}  // namespace smile::scene_xml
