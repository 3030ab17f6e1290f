#pragma once

#include <optional>

#include "base/json.h"

namespace smile::studio {

/// State announcer: selects the states that have to be sent because something has changed.
class StateAnnouncer {
 public:
  /// Returns the message; nullopt if nothing but time has changed since the last one: time alone
  /// is no change, except that a recording is a second longer.
  std::optional<Json> Update(Json state);
  /// Makes the next Update() return the state in any case.
  void Reset() { sent_ = nullptr; }

 private:
  Json sent_;  ///< the last one, without the time
};

}  // namespace smile::studio
