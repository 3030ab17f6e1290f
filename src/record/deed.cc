#include "record/deed.h"

namespace smile::record {
namespace {

using demonstrator::HandName;

Deed ReleaseOf(const sim::Event& event, const std::optional<Support>& support) {
  Deed deed{.kind = DeedKind::kRelease, .hand = *event.hand, .what = event.object};
  if (!support) return deed;
  deed.kind = support->is_near() ? DeedKind::kPut : DeedKind::kDrop;
  deed.onto = support;
  return deed;
}

}  // namespace

std::string_view ToString(DeedKind kind) {
  using enum DeedKind;
  switch (kind) {
    case kTake:
      return "take";
    case kPut:
      return "put";
    case kDrop:
      return "drop";
    case kRelease:
      return "release";
    case kDestroy:
      return "destroy";
    case kPoint:
      return "point";
    case kTrigger:
      return "trigger";
    case kFasten:
      return "fasten";
    case kLoosen:
      return "loosen";
  }
  return "";
}

std::optional<Deed> DeedOf(const sim::Event& event, const std::optional<Support>& support) {
  if (!BeginsSegment(event)) return std::nullopt;
  const auto deed = [&event](DeedKind kind, const std::string& what) {
    return Deed{.kind = kind, .hand = *event.hand, .what = what, .onto = {}};
  };
  using enum sim::EventKind;
  switch (event.kind) {
    case kGrasped:
      return deed(DeedKind::kTake, event.object);
    case kReleased:
      return ReleaseOf(event, support);
    case kDestroyed:
      return deed(DeedKind::kDestroy, event.object);
    case kPointed:
      return deed(DeedKind::kPoint, event.part);
    case kTriggered:
      return deed(DeedKind::kTrigger, event.control);
    case kFastened:
      return deed(DeedKind::kFasten, event.object);
    case kLoosened:
      return deed(DeedKind::kLoosen, event.object);
    default:
      return std::nullopt;
  }
}

std::string WordsOf(const Deed& deed) {
  const bool is_one_hand = deed.hand != HandName::kBoth;
  std::string words(ToString(deed.hand));
  words += is_one_hand ? " hand " : " hands ";
  words += ToString(deed.kind);
  words += is_one_hand ? "s " : " ";
  words += (deed.kind == DeedKind::kPoint ? "at " : "") + deed.what;
  if (!deed.onto) return words;
  words += deed.onto->is_container ? " into " : " on ";
  return words + (deed.onto->object.empty() ? "the table" : deed.onto->object);
}

Json ToJson(const std::optional<Deed>& deed) {
  if (!deed) return nullptr;
  Json json = {{"do", ToString(deed->kind)}, {"hand", ToString(deed->hand)}, {"what", deed->what}};
  if (const auto& onto = deed->onto) json[onto->is_container ? "into" : "on"] = onto->object;
  json["words"] = WordsOf(*deed);
  return json;
}

}  // namespace smile::record
