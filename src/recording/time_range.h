#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::recording {

/// A part of a demonstration, in seconds since it began.
struct TimeRange {
  std::optional<double> from, to;  ///< nullopt: its beginning, its end

  bool operator==(const TimeRange&) const = default;
};

/// The same in ticks of the simulation, both ends included.
struct TickRange {
  std::uint64_t first = 0, last = 0;

  bool operator==(const TickRange&) const = default;
};

/// All that the trace of a recording holds.
/// @throws InputError if the trace cannot be read.
TickRange TicksOf(const Recording& recording);
/// The ticks nearest to the ends of a range.
/// @throws std::invalid_argument if an end is negative or beyond the end of the recording, or
/// `from`
///         is after `to`.
/// @throws InputError if the trace cannot be read.
TickRange TicksOf(const TimeRange& range, const Recording& recording);
/// The tick nearest to a time [s since the demonstration began].
/// @param whole  of the recording.
/// @param name   of the time, for messages.
/// @throws std::invalid_argument if it is negative or beyond the end.
std::uint64_t TickAt(double seconds, const TickRange& whole, const std::string& name);

/// How late a tick is [s since the demonstration began]; negative before.
double SecondsInto(const Recording& recording, std::uint64_t tick);

/// True when frame k is due: at the first tick that is at least k / frames_per_second after the
/// first one.
bool IsFrameDue(std::uint64_t frame, std::uint64_t ticks_since_first, double frames_per_second);

/// The moment at a tick, and the last one; nullopt where the trace holds none.
/// @throws InputError if the trace cannot be read.
std::optional<TraceTick> MomentAt(const Recording& recording, std::uint64_t tick);
std::optional<TraceTick> LastMoment(const Recording& recording);

}  // namespace smile::recording
