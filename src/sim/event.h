#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demonstrator/hand.h"
#include "model/indices.h"

namespace smile::sim {

/// Kinds of events. Traces contain them as numbers: add new kinds at the end.
enum class EventKind {
  kGrasped,         ///< a hand took an object
  kReleased,        ///< a hand released it
  kDestroyed,       ///< a hand took an object out of the world
  kPointed,         ///< a hand pointed at `part` of an object
  kTriggered,       ///< a hand pressed or triggered `control`
  kControlChanged,  ///< `control` shows another `state`
  kFastened,        ///< `object` is fastened one stage tighter, to `tightness`
  /// `object` is loosened one stage, to `tightness`; 0: it came free, without a hand if one of the
  /// two was destroyed
  kLoosened,         ///< `
  kAttended,         ///< a hand pointed out `properties` of the object it holds
  kFell,             ///< an object left the table and lies on the floor, out of play
  kGripperHolds,     ///< a closing gripper grasped an object
  kGripperReleased,  ///< an opening gripper released it
  kCommandRefused,   ///< a command was not carried out, for the `reason`
  kAdded,            ///< `objects` were added to the scene
  kRemoved,          ///< `objects` were removed from the world, without a hand
  kCleared,          ///< the same for all objects except held ones
  kLoaded,           ///< another scene was loaded, its name in `object`; in no trace
  kPressed,          ///< contact pressed `control` of `object`: an `arm`, or the object `by`
  /// a tool, `by`, was used: `state` is `cut`, `fasten` or `loosen`, `part` in words what it worked
  /// on, which is (a part of) `object`; without a hand if it was not by a command
  kUsed,
  kDisplaced,  ///< `objects` were moved together at once, without a hand
};

std::string_view ToString(EventKind kind);

/// An event.
struct Event {
  EventKind kind = EventKind::kCommandRefused;
  std::optional<demonstrator::HandName> hand;  ///< hand that caused it, if any
  std::string arm;                             ///< `left` or `right`, for events of grippers
  std::string object;                          ///< id of the object concerned
  std::string reason;

  std::string part;                        ///< id of the part pointed at
  std::string control;                     ///< id of the control concerned
  std::string state;                       ///< as in recordings, see model::RecordedState()
  std::optional<model::GuestIndex> guest;  ///< for events of bonds
  std::optional<model::HostIndex> host;    ///< for events of bonds
  int tightness = 0;
  std::vector<std::string> properties;  ///< properties that matter; empty: none in particular
  std::string by;                       ///< id of the object that did it; empty: the arm or table
  std::vector<std::string> objects;     ///< ids of the added or removed objects, in scene order

  bool operator==(const Event&) const = default;
};

}  // namespace smile::sim
