#pragma once

#include <cstdint>
#include <vector>

#include "recording/demonstration.h"

namespace smile::editing {

/// Command of a demonstration, with its offset from the start of the demonstration.
struct TrackCommand {
  recording::SegmentCommand command;
  int segment = 0;  ///< its number
};

/// Returns all commands, in order.
std::vector<TrackCommand> CommandsOf(const recording::Demonstration& demonstration);

/// Sorts commands by time and cuts them into segments: each action begins the one with its number.
/// They have no pauses.
/// @param duration  [ticks] of all segments together.
std::vector<recording::EditableSegment> CutAtActions(std::vector<TrackCommand> commands,
                                                     std::uint64_t duration);

}  // namespace smile::editing
