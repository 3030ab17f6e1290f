#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::recording {

/// Part of a demonstration, in seconds since its begin.
struct TimeRange {
  std::optional<double> from, to;  ///< nullopt: its beginning, its end

  bool operator==(const TimeRange&) const = default;
};

/// Range of ticks of the simulation, both ends included.
struct TickRange {
  std::uint64_t first = 0, last = 0;

  bool operator==(const TickRange&) const = default;
};

/// Returns all ticks in the trace of a recording.
/// @throws InputError if the trace cannot be read.
TickRange TicksOf(const Recording& recording);
/// Returns the ticks nearest to the ends of a range.
/// @throws std::invalid_argument if an end is negative or beyond the end of the recording, or
/// `from`
///         is after `to`.
/// @throws InputError if the trace cannot be read.
TickRange TicksOf(const TimeRange& range, const Recording& recording);
/// Returns the tick nearest to a time [s since the demonstration began].
/// @param whole  of the recording.
/// @param name   of the time, for messages.
/// @throws std::invalid_argument if it is negative or beyond the end.
std::uint64_t TickAt(double seconds, const TickRange& whole, const std::string& name);

/// Returns the time of a tick [s since the demonstration began]; negative before.
double SecondsInto(const Recording& recording, std::uint64_t tick);

/// True if frame k is due: at the first tick that is at least k / frames_per_second after the first
/// one.
bool IsFrameDue(std::uint64_t frame, std::uint64_t ticks_since_first, double frames_per_second);

/// Return the moment at a tick, and the last one; nullopt if the trace does not have it.
/// @throws InputError if the trace cannot be read.
std::optional<TraceTick> MomentAt(const Recording& recording, std::uint64_t tick);
std::optional<TraceTick> LastMoment(const Recording& recording);

}  // namespace smile::recording
