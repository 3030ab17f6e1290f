#include "editing/overlay.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "editing/internal_tracks.h"
#include "sim/action_summary.h"

namespace smile::editing {
namespace {

using demonstrator::HandName;
using recording::SegmentCommand;

/// Gives a command to another hand.
void GiveTo(HandName hand, SegmentCommand* command) {
  std::visit(
      [&](auto& what) {
        if constexpr (requires { what.hand; }) {
          if (what.hand == HandName::kBoth) {
            throw std::invalid_argument("line " + std::to_string(command->line) +
                                        " of its log is done by both hands, expected one hand");
          }
          what.hand = hand;
        }
      },
      command->command);
}

/// Returns the commands of hands, with offsets from the start of the first demonstration.
std::vector<TrackCommand> HandCommandsOf(const Overlay& overlay, std::size_t num_lines) {
  std::vector<TrackCommand> commands = CommandsOf(overlay.demonstration);
  std::erase_if(commands, [](const TrackCommand& one) {
    return !sim::HandOf(one.command.command).has_value();
  });
  if (commands.empty()) {
    throw std::invalid_argument("it has no command of a hand, expected a demonstration by hands");
  }
  for (auto& [command, segment] : commands) {
    if (overlay.hand) GiveTo(*overlay.hand, &command);
    command.offset += overlay.begin;
    command.line += num_lines;
  }
  return commands;
}

}  // namespace

recording::Demonstration Overlaid(const recording::Demonstration& first, const Overlay& overlay,
                                  std::size_t num_lines) {
  std::vector<TrackCommand> commands = CommandsOf(first);
  for (TrackCommand& one : HandCommandsOf(overlay, num_lines)) commands.push_back(std::move(one));
  recording::Demonstration both = first;
  both.segments =
      CutAtActions(std::move(commands),
                   std::max(first.duration(), overlay.begin + overlay.demonstration.duration()));
  for (const auto& [line, pose] : overlay.demonstration.grasped) {
    both.grasped[num_lines + line] = pose;
  }
  both.num_recorded = static_cast<int>(both.segments.size());
  for (int i = 0; i < both.num_recorded; ++i) both.segments[static_cast<std::size_t>(i)].number = i;
  return both;
}

}  // namespace smile::editing
