#pragma once

#include <optional>

#include "base/json.h"

namespace smile::studio {

/// Tells pages the state when it has changed.
class StateAnnouncer {
 public:
  /// Returns the message; nullopt if nothing but time has changed since the last one: time alone
  /// is no change, except that a recording is a second longer.
  std::optional<Json> Tell(Json state);
  /// The next state is told, whatever it is.
  void Forget() { told_ = nullptr; }

 private:
  Json told_;  ///< without the time
};

}  // namespace smile::studio
