#include "scene_import/import_findings.h"

#include <algorithm>

namespace smile::scene_import {
namespace {

constexpr std::size_t kMaxFaults = 100;
constexpr std::size_t kListedLines = 20;

/// Returns ` (also in lines 7, 9 and 3 more)`; empty for none.
std::string LinesText(const std::vector<int>& lines) {
  if (lines.empty()) return "";
  std::string text = lines.size() == 1 ? " (also in line " : " (also in lines ";
  const std::size_t num_listed = std::min(lines.size(), kListedLines);
  for (std::size_t i = 0; i < num_listed; ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(lines[i]);
  }
  if (lines.size() > num_listed)
    text += " and " + std::to_string(lines.size() - num_listed) + " more";
  return text + ")";
}

}  // namespace

void ImportFindings::Refuse(const Place& place, const std::string& message) {
  if (faults_.size() == kMaxFaults) return;
  faults_.push_back({place.file, place.line, place.element, message});
}

void ImportFindings::Remark(const Place& place, const std::string& message) {
  const std::string name = place.element.substr(0, place.element.find(' '));
  const auto [known, is_new] = index_.try_emplace({place.file, name, message}, remarks_.size());
  if (is_new) {
    remarks_.push_back({.first = {place.file, place.line, place.element, message}});
  } else {
    remarks_[known->second].more_lines.push_back(place.line);
  }
}

void ImportFindings::ThrowIfRefused() const {
  if (!faults_.empty()) throw InputError(faults_);
}

std::vector<Diagnostic> ImportFindings::Remarks() const {
  std::vector<Diagnostic> list;
  for (const CountedRemark& remark : remarks_) {
    list.push_back(remark.first);
    list.back().message += LinesText(remark.more_lines);
  }
  return list;
}

}  // namespace smile::scene_import
