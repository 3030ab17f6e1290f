// Properties of held objects that matter.

#include <algorithm>

#include "base/wording.h"
#include "demonstrator/demonstrator.h"

namespace smile::demonstrator {

using texts::Say;

namespace {

/// Returns the properties that all objects have, and those described for this one.
std::vector<std::string_view> PropertiesOf(const scene::ObjectSpec& object) {
  std::vector<std::string_view> known = {"color",       "shape", "size",   "position",
                                         "orientation", "order", "support"};
  for (const scene::Description& description : object.descriptions) {
    // Descriptions may repeat a general property, such as `color`.
    const bool is_new = std::ranges::find(known, description.name) == known.end();
    if (is_new && description.name.size() <= kMaxPropertyLength) known.push_back(description.name);
  }
  return known;
}

}  // namespace

std::optional<Refusal> Demonstrator::Attend(HandName name,
                                            const std::vector<std::string>& properties) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  if (properties.size() > kMaxProperties) {
    return Say("hands.tooManyProperties",
               {{"number", properties.size()}, {"limit", kMaxProperties}});
  }
  const world::Object& object = *tabletop_->Find(hand(name).held);
  const std::vector<std::string_view> known = PropertiesOf(*object.spec);
  std::vector<std::string> attended;
  for (const std::string& word : properties) {
    // Stored under one spelling, so that recordings compare equal.
    const std::string property = word == "colour" ? "color" : word;
    if (std::ranges::find(known, property) == known.end()) {
      return Say("hands.noProperty", {{"object", object.id()},
                                      {"property", Quoted(word)},
                                      {"known", OneOf(known) + DidYouMean(word, known)}});
    }
    if (std::ranges::find(attended, property) == attended.end()) attended.push_back(property);
  }
  // No entry instead of an empty one: equal states must have equal hashes.
  if (attended.empty()) {
    state_.attention.erase(object.body);
  } else {
    state_.attention[object.body] = std::move(attended);
  }
  return std::nullopt;
}

const std::vector<std::string>& Demonstrator::PropertiesThatMatter(
    const world::Object& object) const {
  static const std::vector<std::string> kNone;
  const auto attended = state_.attention.find(object.body);
  return attended != state_.attention.end() ? attended->second : kNone;
}

}  // namespace smile::demonstrator
