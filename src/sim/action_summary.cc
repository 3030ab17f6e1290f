#include "sim/action_summary.h"

// The one place that decides what is an action: a kind of command that EventOfAction() pairs with
// an event. Everything else (undo, segments of recordings, texts on the page) follows from it.

namespace smile::sim {
namespace {

/// A release is a put, a drop or a plain release, depending on the support.
ActionSummary SummaryOfRelease(const Event& event, const std::optional<model::Support>& support) {
  ActionSummary summary{.kind = ActionKind::kRelease, .hand = event.hand, .what = event.object};
  // Beyond the table's edge it is neither put nor dropped.
  if (!support) return summary;
  summary.kind = support->is_near() ? ActionKind::kPut : ActionKind::kDrop;
  summary.onto = support;
  return summary;
}

/// Returns true if a command of the kind is an action that such an event reports. Events of bonds
/// also occur without a hand, when an object is destroyed; those begin no action.
template <class Kind>
bool Reports(const Event& event) {
  // Decided by the type: kinds of hands have a member `hand`.
  constexpr bool kIsOfHand = requires(Kind kind) { kind.hand; };
  return EventOfAction<Kind>() == event.kind && (event.hand.has_value() || !kIsOfHand);
}
template <class... Kinds>
bool ReportsOneOf(const Event& event, const std::variant<Kinds...>*) {
  return (Reports<Kinds>(event) || ...);
}

/// Returns the id of a single object, or the number of several.
std::string NameOf(const std::vector<std::string>& objects) {
  if (objects.size() == 1) return objects.front();
  return (objects.empty() ? "" : std::to_string(objects.size()) + " ") + "objects";
}

}  // namespace

std::optional<HandName> HandOf(const Command& command) {
  return std::visit(
      [](const auto& what) -> std::optional<HandName> {
        if constexpr (requires { what.hand; }) {
          return what.hand;
        } else {
          return std::nullopt;
        }
      },
      command);
}

bool IsAction(const Command& command) {
  return std::visit([]<class Kind>(const Kind&) { return EventOfAction<Kind>().has_value(); },
                    command);
}

bool BeginsAction(const Event& event) {
  // Only its type is used, to expand the kinds of the variant.
  constexpr const Command* kAnyCommand = nullptr;
  return ReportsOneOf(event, kAnyCommand);
}

std::string_view ToString(ActionKind kind) {
  using enum ActionKind;
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
    case kCut:
      return "cut";
    case kAdd:
      return "add";
    case kRemove:
      return "remove";
    case kMove:
      return "move";
    case kClear:
      return "clear";
    case kLoad:
      return "load";
  }
  return "";
}

std::optional<ActionSummary> SummaryOf(const Event& event,
                                       const std::optional<model::Support>& support) {
  // Other events are consequences of an action and have no summary.
  if (!BeginsAction(event)) return std::nullopt;
  const auto summary = [&event](ActionKind kind, const std::string& what) {
    return ActionSummary{.kind = kind, .hand = event.hand, .what = what, .onto = {}};
  };
  const auto summary_of_use = [&] {
    ActionSummary use = summary(event.state == "cut"      ? ActionKind::kCut
                                : event.state == "fasten" ? ActionKind::kFasten
                                                          : ActionKind::kLoosen,
                                event.part);
    use.with = event.by;
    return use;
  };
  using enum EventKind;
  // The name of the object, part or control that people would say.
  switch (event.kind) {
    case kGrasped:
      return summary(ActionKind::kTake, event.object);
    case kReleased:
      return SummaryOfRelease(event, support);
    case kDestroyed:
      return summary(ActionKind::kDestroy, event.object);
    case kPointed:
      return summary(ActionKind::kPoint, event.part);
    case kTriggered:
      return summary(ActionKind::kTrigger, event.control);
    case kFastened:
      return summary(ActionKind::kFasten, event.object);
    case kLoosened:
      return summary(ActionKind::kLoosen, event.object);
    case kUsed:
      return summary_of_use();
    case kAdded:
      return summary(ActionKind::kAdd, NameOf(event.objects));
    case kRemoved:
      return summary(ActionKind::kRemove, NameOf(event.objects));
    case kDisplaced:
      return summary(ActionKind::kMove, NameOf(event.objects));
    case kCleared:
      return summary(ActionKind::kClear, NameOf(event.objects));
    case kLoaded:
      return summary(ActionKind::kLoad, event.object);
    default:
      return std::nullopt;
  }
}

std::string WordsOf(const ActionSummary& summary) {
  if (summary.kind == ActionKind::kAdd) return "added " + summary.what;
  if (summary.kind == ActionKind::kRemove) return "removed " + summary.what;
  if (summary.kind == ActionKind::kMove) return "moved " + summary.what;
  if (summary.kind == ActionKind::kClear) return "cleared the table of " + summary.what;
  if (summary.kind == ActionKind::kLoad) return "loaded " + summary.what;
  const bool is_one_hand = summary.hand != HandName::kBoth;
  // All other actions are those of hands: subject, verb, object.
  std::string words(ToString(*summary.hand));
  words += is_one_hand ? " hand " : " hands ";
  words += ToString(summary.kind);
  // Third person for one hand, plural for both: `left hand takes`, `both hands take`.
  words += is_one_hand ? "s " : " ";
  words += (summary.kind == ActionKind::kPoint ? "at " : "") + summary.what;
  if (!summary.with.empty()) words += " with " + summary.with;
  if (!summary.onto) return words;
  words += summary.onto->is_inside ? " into " : " on ";
  return words + (summary.onto->object.empty() ? "the table" : summary.onto->object);
}

Json ToJson(const std::optional<ActionSummary>& summary) {
  if (!summary) return nullptr;
  Json json = {{"do", ToString(summary->kind)}, {"hand", nullptr}, {"what", summary->what}};
  if (summary->hand) json["hand"] = ToString(*summary->hand);
  if (!summary->with.empty()) json["with"] = summary->with;
  if (const auto& onto = summary->onto) json[onto->is_inside ? "into" : "on"] = onto->object;
  json["words"] = WordsOf(*summary);
  return json;
}

}  // namespace smile::sim
