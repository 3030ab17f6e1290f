#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demonstrator/hand.h"
#include "model/indices.h"

namespace smile::sim {

/// Traces hold these as numbers: new kinds go to the end.
enum class EventKind {
  kGrasped,         ///< a hand took an object
  kReleased,        ///< a hand let go of it
  kDestroyed,       ///< a hand took an object out of the world
  kPointed,         ///< a hand pointed at `part` of an object
  kTriggered,       ///< a hand pressed or triggered `control`
  kControlChanged,  ///< `control` shows another `state`
  kFastened,        ///< `object` is fastened one stage tighter, to `tightness`
  kLoosened,        ///< `object` is loosened one stage, to `tightness`; 0: it came free, by no
                    ///< hand when one of the two was destroyed
  kAttended,        ///< a hand told which `properties` of the object it holds matter
  kFell,            ///< an object left the table and lies on the floor, out of play
  kGripperHolds,    ///< a closing gripper got hold of an object
  kGripperLetGo,    ///< an opening gripper let go of it
  kCommandRefused,  ///< a command was not carried out; `reason` says why
  kAdded,           ///< `objects` were added to the scene
  kRemoved,         ///< `objects` were taken out of the world, by no hand
  kCleared,         ///< likewise: all but what was held
  kLoaded,          ///< another scene was loaded, its name in `object`; in no trace
};

std::string_view ToString(EventKind kind);

/// Something that happened.
struct Event {
  EventKind kind = EventKind::kCommandRefused;
  std::optional<demonstrator::HandName> hand;  ///< whose doing it was, where a hand's
  std::string arm;                             ///< `left` or `right`, where a gripper's
  std::string object;                          ///< id of the object it happened to
  std::string reason;

  std::string part;                        ///< id of what was pointed at
  std::string control;                     ///< id of the control it happened to
  std::string state;                       ///< as recordings have it, see model::RecordedState()
  std::optional<model::GuestIndex> guest;  ///< where a bond's
  std::optional<model::HostIndex> host;    ///< where a bond's
  int tightness = 0;
  std::vector<std::string> properties;  ///< that matter; none: nothing in particular
  std::vector<std::string> objects;     ///< ids of those that were added or removed, in scene order

  bool operator==(const Event&) const = default;
};

}  // namespace smile::sim
