#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/json.h"
#include "model/relations.h"
#include "sim/command.h"
#include "sim/event.h"

namespace smile::sim {

/// The definition of an action: a command of a kind that has an event here. This event reports the
/// action, with a hand if the command has one. An action can be undone, and begins a new segment of
/// a recording. nullopt for commands that belong to the action before them.
template <class Kind>
constexpr std::optional<EventKind> EventOfAction() {
  if constexpr (std::is_same_v<Kind, Grasp>) return EventKind::kGrasped;
  if constexpr (std::is_same_v<Kind, Release>) return EventKind::kReleased;
  if constexpr (std::is_same_v<Kind, Destroy>) return EventKind::kDestroyed;
  if constexpr (std::is_same_v<Kind, Point>) return EventKind::kPointed;
  if constexpr (std::is_same_v<Kind, Trigger>) return EventKind::kTriggered;
  if constexpr (std::is_same_v<Kind, Fasten>) return EventKind::kFastened;
  if constexpr (std::is_same_v<Kind, Loosen>) return EventKind::kLoosened;
  if constexpr (std::is_same_v<Kind, Use>) return EventKind::kUsed;
  if constexpr (std::is_same_v<Kind, Spawn>) return EventKind::kAdded;
  if constexpr (std::is_same_v<Kind, Remove>) return EventKind::kRemoved;
  if constexpr (std::is_same_v<Kind, Displace>) return EventKind::kDisplaced;
  if constexpr (std::is_same_v<Kind, Clear>) return EventKind::kCleared;
  if constexpr (std::is_same_v<Kind, Load>) return EventKind::kLoaded;
  return std::nullopt;
}

/// Returns the hand of a command, if it has one.
std::optional<HandName> HandOf(const Command& command);
/// Returns true for a command that begins an action.
bool IsAction(const Command& command);
/// Returns true for the event that reports an action. Each action has exactly one.
bool BeginsAction(const Event& event);

/// Kind of an action. Releases are distinguished by the support of the object.
enum class ActionKind {
  kTake,
  kPut,      ///< released where it already lay
  kDrop,     ///< released above something
  kRelease,  ///< released beyond the table
  kDestroy,
  kPoint,
  kTrigger,
  kFasten,
  kLoosen,
  kCut,
  kAdd,
  kRemove,
  kMove,
  kClear,
  kLoad
};
/// Returns `take`, `put`, `drop`, `release`, `destroy`, `point`, `trigger`, `fasten`, `loosen`,
/// `cut`, `add`, `remove`, `move`, `clear` or `load`.
std::string_view ToString(ActionKind kind);

/// Summary of an action.
struct ActionSummary {
  ActionKind kind = ActionKind::kTake;
  std::optional<HandName> hand;  ///< nullopt if no hand did it
  /// id of the object, part or control; the number of several objects: `5 objects`; or the name of
  /// the scene
  std::string what;
  std::string with;                    ///< id of the tool; empty without one
  std::optional<model::Support> onto;  ///< for a put or dropped object

  bool operator==(const ActionSummary&) const = default;
};

/// Returns the summary of an action.
/// @param support  of a released object.
/// @returns nullopt for events that report no action.
std::optional<ActionSummary> SummaryOf(const Event& event,
                                       const std::optional<model::Support>& support);

/// Returns a phrase: `left hand takes b03`, `both hands put b03 on b01`, `right hand drops b03 into
/// crate`; `added b03`, `removed b03`, `moved 3 objects`, `cleared the table of 5 objects`, `loaded
/// um`.
std::string WordsOf(const ActionSummary& summary);

/// Returns `{"do":"take","hand":"left","what":"b03","words":"left hand takes b03"}`; with
/// a tool also `"with"`; for a put or dropped object also `"on"` or `"into"` with the id of its
/// support, empty for the table. `hand` is null if no hand did it. Returns null for nullopt.
Json ToJson(const std::optional<ActionSummary>& summary);

}  // namespace smile::sim
