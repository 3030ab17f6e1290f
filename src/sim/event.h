#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "demonstrator/hand.h"

namespace smile::sim {

enum class EventKind {
  kGrasped,         ///< a hand took an object
  kReleased,        ///< a hand let go of it
  kGripperHolds,    ///< a closing gripper got hold of an object
  kGripperLetGo,    ///< an opening gripper let go of it
  kCommandRefused,  ///< a command was not carried out; `reason` says why
};

std::string_view ToString(EventKind kind);

/// Something that happened.
struct Event {
  EventKind kind = EventKind::kCommandRefused;
  std::optional<demonstrator::HandName> hand;  ///< whose doing it was, where a hand's
  std::string arm;                             ///< `left` or `right`, where a gripper's
  std::string object;                          ///< id of the object it happened to
  std::string reason;

  bool operator==(const Event&) const = default;
};

}  // namespace smile::sim
