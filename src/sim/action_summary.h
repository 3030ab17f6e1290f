#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/json.h"
#include "model/relations.h"
#include "sim/command.h"
#include "sim/event.h"

namespace smile::sim {

/// The one definition of an action: a command of a kind that has an event here, reported by this
/// event, of a hand if the command is one of a hand. It can be undone, and it begins a new segment
/// of a recording. nullopt for commands that belong to the action before them.
template <class Kind>
constexpr std::optional<EventKind> EventOfAction() {
  if constexpr (std::is_same_v<Kind, Grasp>) return EventKind::kGrasped;
  if constexpr (std::is_same_v<Kind, Release>) return EventKind::kReleased;
  if constexpr (std::is_same_v<Kind, Destroy>) return EventKind::kDestroyed;
  if constexpr (std::is_same_v<Kind, Point>) return EventKind::kPointed;
  if constexpr (std::is_same_v<Kind, Trigger>) return EventKind::kTriggered;
  if constexpr (std::is_same_v<Kind, Fasten>) return EventKind::kFastened;
  if constexpr (std::is_same_v<Kind, Loosen>) return EventKind::kLoosened;
  if constexpr (std::is_same_v<Kind, Spawn>) return EventKind::kAdded;
  if constexpr (std::is_same_v<Kind, Remove>) return EventKind::kRemoved;
  if constexpr (std::is_same_v<Kind, Clear>) return EventKind::kCleared;
  if constexpr (std::is_same_v<Kind, Load>) return EventKind::kLoaded;
  return std::nullopt;
}

/// Whose doing a command is, where a hand's.
std::optional<HandName> HandOf(const Command& command);
/// True of a command that begins an action.
bool IsAction(const Command& command);
/// True of the event that reports an action. Each action has exactly one.
bool BeginsAction(const Event& event);

enum class ActionKind {
  kTake,
  kPut,      ///< let go of where it lay already
  kDrop,     ///< let go of above something
  kRelease,  ///< let go of beyond the table
  kDestroy,
  kPoint,
  kTrigger,
  kFasten,
  kLoosen,
  kAdd,
  kRemove,
  kClear,
  kLoad
};
/// `take`, `put`, `drop`, `release`, `destroy`, `point`, `trigger`, `fasten`, `loosen`, `add`,
/// `remove`, `clear`, `load`.
std::string_view ToString(ActionKind kind);

/// An action in short.
struct ActionSummary {
  ActionKind kind = ActionKind::kTake;
  std::optional<HandName> hand;        ///< nullopt of what no hand did
  std::string what;                    ///< id of the object, or part pointed at, or control; where
                                       ///< there are several objects, how many: `5 objects`; or
                                       ///< the name of the scene
  std::optional<model::Support> onto;  ///< of what was put or dropped

  bool operator==(const ActionSummary&) const = default;
};

/// @param support  of what a hand let go of.
/// @returns nullopt for events that report no action.
std::optional<ActionSummary> SummaryOf(const Event& event,
                                       const std::optional<model::Support>& support);

/// `left hand takes b03`, `both hands put b03 on b01`, `right hand drops b03 into crate`; `added
/// b03`, `removed b03`, `cleared the table of 5 objects`, `loaded um`.
std::string WordsOf(const ActionSummary& summary);

/// `{"do":"take","hand":"left","what":"b03","words":"left hand takes b03"}`; of what was put or
/// dropped also `"on"` or `"into"` and the id of what is beneath, empty for the table. `hand` is
/// null of what no hand did. null of none.
Json ToJson(const std::optional<ActionSummary>& summary);

}  // namespace smile::sim
