#include "recording/time_range.h"

#include <cmath>
#include <stdexcept>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "recording/trace_reader.h"

namespace smile::recording {
namespace {

/// Returns seconds for a message, rounded to milliseconds: a sixtieth of a second remains
/// identifiable.
std::string SecondsText(double seconds) { return NumberText(std::round(seconds * 1000) / 1000); }

}  // namespace

TickRange TicksOf(const Recording& recording) {
  const std::uint64_t begin = recording.info.start.tick;
  TraceReader trace(recording);
  const std::optional<TraceTick> first = trace.Next();
  if (first && first->tick != begin) {
    throw InputError({(recording.directory / "trace.bin").string(), 0, "",
                      "begins at tick " + std::to_string(first->tick) +
                          ", but demo.json says at tick " + std::to_string(begin)});
  }
  return {.first = begin, .last = trace.LastTick().value_or(begin)};
}

std::uint64_t TickAt(double seconds, const TickRange& whole, const std::string& name) {
  const std::string found = name + " is " + NumberText(seconds) + " s";
  // Written so that NaN fails.
  if (!(seconds >= 0)) throw std::invalid_argument(found + ", expected 0 or more");
  const double ticks = std::round(seconds * sim::kTicksPerSecond);
  const auto num_ticks = static_cast<double>(whole.last - whole.first);
  if (ticks > num_ticks) {
    throw std::invalid_argument(found + ", but the recording is " +
                                SecondsText(num_ticks / sim::kTicksPerSecond) + " s long");
  }
  return whole.first + static_cast<std::uint64_t>(ticks);
}

TickRange TicksOf(const TimeRange& range, const Recording& recording) {
  const TickRange whole = TicksOf(recording);
  const TickRange ticks{.first = range.from ? TickAt(*range.from, whole, "from") : whole.first,
                        .last = range.to ? TickAt(*range.to, whole, "to") : whole.last};
  if (ticks.first > ticks.last) {
    throw std::invalid_argument("from is " + NumberText(*range.from) + " s, which is after to, " +
                                NumberText(*range.to) + " s");
  }
  return ticks;
}

double SecondsInto(const Recording& recording, std::uint64_t tick) {
  const std::uint64_t start = recording.info.start.tick;
  // Negative before the start: ticks are unsigned, so the difference is taken the other way.
  return tick >= start ? sim::SecondsOf(tick - start) : -sim::SecondsOf(start - tick);
}

bool IsFrameDue(std::uint64_t frame, std::uint64_t ticks_since_first, double frames_per_second) {
  // Allows for rounding in the division, so that a frame due exactly at a tick is not late by one.
  constexpr double kRounding = 1e-9;  // [ticks]
  // By the number of the frame and not by adding up periods, which would accumulate rounding.
  const double due = static_cast<double>(frame) * sim::kTicksPerSecond / frames_per_second;
  return static_cast<double>(ticks_since_first) + kRounding >= due;
}

std::optional<TraceTick> MomentAt(const Recording& recording, std::uint64_t tick) {
  return TraceReader(recording).At(tick);
}

std::optional<TraceTick> LastMoment(const Recording& recording) {
  return TraceReader(recording).Last();
}

}  // namespace smile::recording
