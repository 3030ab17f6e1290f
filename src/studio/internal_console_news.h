#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "base/json.h"
#include "studio/console.h"

namespace smile::studio {

/// Tells pages what robot programs print, and those that come later the last of it.
class ConsoleNews {
 public:
  /// nullopt without lines.
  std::optional<Json> Tell(const std::vector<ConsoleLine>& lines);
  /// The last lines; nullopt if there were none.
  std::optional<Json> Everything() const;

 private:
  std::deque<Json> told_;
};

}  // namespace smile::studio
