#include "scene_xml/internal_references.h"

#include <string_view>
#include <utility>

#include "base/wording.h"

// Ids in a file need not be unique, as templates repeat them, and then get a suffix. A reference is
// accepted if it is clear what it means: a final id, or a written id that only one element has.

namespace smile::scene_xml {
namespace {

// Limits of messages: ids listed, and ids compared for spelling suggestions.
constexpr std::size_t kMaxNamesShown = 3;
constexpr std::size_t kMaxSuggestedIds = 100;

std::string_view NameOf(Target target) {
  return target == Target::kControl ? "control" : "hostBondPoint";
}

}  // namespace

void References::Declare(Target target, const std::string& written, const std::string& id) {
  Names& names = names_[static_cast<int>(target)];
  names.ids.insert(id);
  if (!written.empty()) names.ids_of_written[written].push_back(id);
}

// The ticket is an index as text.
std::string References::Add(Reference reference) {
  references_.push_back(std::move(reference));
  return std::to_string(references_.size() - 1);
}

const Reference& References::Of(const std::string& ticket) const {
  return references_.at(std::stoul(ticket));
}

std::string References::Find(const Reference& reference, Findings* findings) const {
  const Names& names = NamesOf(reference.target);
  // A unique id has priority over written ids, which several elements may share.
  if (names.ids.contains(reference.text)) return reference.text;
  const std::string kind(NameOf(reference.target));
  std::string expected = "the id of a " + kind + " in this scene";
  const auto written = names.ids_of_written.find(reference.text);
  if (written != names.ids_of_written.end()) {
    const std::vector<std::string>& ids = written->second;
    if (ids.size() == 1) return ids.front();
    std::vector<std::string_view> shown(ids.begin(), ids.end());
    if (shown.size() > kMaxNamesShown) shown.resize(kMaxNamesShown);
    expected = OneOf(shown) + ": the file has " + std::to_string(ids.size()) + " " + kind +
               "s with this id";
    // A suggestion compares with many ids, which is wasted on a finding that is not shown.
  } else if (!findings->is_full()) {
    std::vector<std::string_view> known;
    for (const std::string& id : names.ids) {
      if (known.size() < kMaxSuggestedIds) known.push_back(id);
    }
    expected += DidYouMean(reference.text, known);
  }
  findings->Add(
      reference.place, reference.element,
      "found " + reference.attribute + "=" + Quoted(reference.text) + ", expected " + expected);
  return {};
}

}  // namespace smile::scene_xml
