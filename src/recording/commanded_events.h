#pragma once

#include <array>
#include <optional>
#include <string>

#include "sim/action_summary.h"

namespace smile::recording {

/// Derives the events of actions from their commands, for logs whose trace does not report them:
/// traces of old formats contain no events, and a trace may end before its log.
class CommandedEvents {
 public:
  /// Returns the event of the next command; to be called for each command in order.
  /// @returns nullopt unless the command is an action. Fields that only the simulation knew are
  ///          empty.
  std::optional<sim::Event> Next(const sim::Command& command);

 private:
  std::string& HeldBy(sim::HandName hand) { return held_[static_cast<std::size_t>(hand)]; }
  /// Ids of what each hand holds; empty for nothing.
  std::array<std::string, demonstrator::kHandNames.size()> held_;
};

}  // namespace smile::recording
