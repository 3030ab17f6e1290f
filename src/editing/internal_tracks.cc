#include "editing/internal_tracks.h"

#include <algorithm>
#include <utility>

#include "sim/action_summary.h"

namespace smile::editing {

std::vector<TrackCommand> CommandsOf(const recording::Demonstration& demonstration) {
  std::vector<TrackCommand> commands;
  std::uint64_t begin = 0;
  for (const recording::EditableSegment& segment : demonstration.segments) {
    for (recording::SegmentCommand command : segment.commands) {
      command.offset += begin;
      commands.push_back({std::move(command), segment.number});
    }
    begin += segment.duration;
  }
  return commands;
}

std::vector<recording::EditableSegment> CutAtActions(std::vector<TrackCommand> commands,
                                                     std::uint64_t duration) {
  std::ranges::stable_sort(commands, {},
                           [](const TrackCommand& one) { return one.command.offset; });
  std::vector<recording::EditableSegment> segments{{.number = 0}};
  std::uint64_t begin = 0;
  for (auto& [command, number] : commands) {
    if (sim::IsAction(command.command)) {
      segments.back().duration = command.offset - begin;
      begin = command.offset;
      segments.push_back({.number = number});
    }
    command.offset -= begin;
    segments.back().commands.push_back(std::move(command));
  }
  segments.back().duration = duration - begin;
  return segments;
}

}  // namespace smile::editing
