#include "editing/overlay.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "sim/action_summary.h"

namespace smile::editing {
namespace {

using demonstrator::HandName;
using recording::SegmentCommand;

/// Returns all commands, with offsets from the start of the demonstration.
std::vector<SegmentCommand> CommandsOf(const recording::Demonstration& demonstration) {
  std::vector<SegmentCommand> commands;
  std::uint64_t begin = 0;
  for (const recording::EditableSegment& segment : demonstration.segments) {
    for (SegmentCommand command : segment.commands) {
      command.offset += begin;
      commands.push_back(std::move(command));
    }
    begin += segment.duration;
  }
  return commands;
}

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
std::vector<SegmentCommand> HandCommandsOf(const Overlay& overlay, std::size_t num_lines) {
  std::vector<SegmentCommand> commands = CommandsOf(overlay.demonstration);
  std::erase_if(commands, [](const SegmentCommand& command) {
    return !sim::HandOf(command.command).has_value();
  });
  if (commands.empty()) {
    throw std::invalid_argument("it has no command of a hand, expected a demonstration by hands");
  }
  for (SegmentCommand& command : commands) {
    if (overlay.hand) GiveTo(*overlay.hand, &command);
    command.offset += overlay.begin;
    command.line += num_lines;
  }
  return commands;
}

/// Cuts commands, in order, into segments: each action begins one.
std::vector<recording::EditableSegment> CutAtActions(std::vector<SegmentCommand> commands,
                                                     std::uint64_t duration) {
  std::vector<recording::EditableSegment> segments{{.number = 0}};
  std::uint64_t begin = 0;
  for (SegmentCommand& command : commands) {
    if (IsAction(command.command)) {
      segments.back().duration = command.offset - begin;
      begin = command.offset;
      segments.push_back({.number = static_cast<int>(segments.size())});
    }
    command.offset -= begin;
    segments.back().commands.push_back(std::move(command));
  }
  segments.back().duration = duration - begin;
  return segments;
}

}  // namespace

recording::Demonstration Overlaid(const recording::Demonstration& first, const Overlay& overlay,
                                  std::size_t num_lines) {
  std::vector<SegmentCommand> commands = CommandsOf(first);
  for (SegmentCommand& command : HandCommandsOf(overlay, num_lines)) {
    commands.push_back(std::move(command));
  }
  std::ranges::stable_sort(commands, {}, &SegmentCommand::offset);
  recording::Demonstration both = first;
  both.segments =
      CutAtActions(std::move(commands),
                   std::max(first.duration(), overlay.begin + overlay.demonstration.duration()));
  both.num_recorded = static_cast<int>(both.segments.size());
  return both;
}

}  // namespace smile::editing
