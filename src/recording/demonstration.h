#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::recording {

/// A command of a segment.
struct SegmentCommand {
  std::size_t line = 0;      ///< of the log it was recorded in
  std::uint64_t offset = 0;  ///< [ticks] from the begin of its segment
  sim::Command command;

  bool operator==(const SegmentCommand&) const = default;
};

/// Part of a segment, in ticks from its begin.
struct TickSpan {
  std::uint64_t begin = 0, end = 0;

  std::uint64_t length() const { return end - begin; }
  bool operator==(const TickSpan&) const = default;
};

/// A segment to be edited: its commands and pauses in ticks from its begin.
struct EditableSegment {
  int number = 0;  ///< of the Segment in the recording
  /// In order. The first one is the action, at offset 0, except in segment 0, which has none.
  std::vector<SegmentCommand> commands;
  /// Times at rest until the next command or the end; in order.
  std::vector<TickSpan> pauses;
  std::uint64_t duration = 0;  ///< [ticks]

  bool operator==(const EditableSegment&) const = default;
};

/// Demonstration of a recording, segment by segment:
///
///     past | segment 0 | grasp … | release … | grasp … |
///          start                                       end
struct Demonstration {
  std::vector<LoggedCommand> past;  ///< commands before the start
  HistoryPoint start;
  std::vector<EditableSegment> segments;
  int num_recorded = 0;  ///< numbers of segments go from 0 to one less, also when some are dropped
  TraceTick recorded_end;  ///< the last moment of the trace
  /// Where objects were when hands took them, by the line of the grasp.
  std::map<std::size_t, TracePose> grasped;
  double meters_per_unit = 0;

  std::uint64_t duration() const;  ///< [ticks]
  std::uint64_t recorded_duration() const { return recorded_end.tick - start.tick; }
  /// Returns all commands since the simulation began, past and segments, with their ticks, in
  /// order.
  std::vector<LoggedCommand> Schedule() const;
};

/// Cuts the recording's path into segments.
/// @throws InputError if it was imported and has no commands, if its trace cannot be read, or if
///         log and trace contradict each other.
Demonstration DemonstrationOf(const Recording& recording);

}  // namespace smile::recording
