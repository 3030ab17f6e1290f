#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "base/json.h"
#include "studio/console.h"

namespace smile::studio {

/// Console updates: makes messages of the lines that brains print, and keeps the last lines for
/// clients that connect later.
class ConsoleUpdates {
 public:
  /// Returns the message with these lines; nullopt if there are none.
  std::optional<Json> Add(const std::vector<ConsoleLine>& lines);
  /// Returns the message with the last lines; nullopt if there are none.
  std::optional<Json> Everything() const;

 private:
  std::deque<Json> sent_;
};

}  // namespace smile::studio
