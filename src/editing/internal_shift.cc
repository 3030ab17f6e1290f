#include "editing/internal_shift.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/wording.h"
#include "editing/internal_tracks.h"
#include "sim/action_summary.h"
#include "sim/simulation.h"

namespace smile::editing {
namespace {

/// What a hand does, from one of its actions on, among all that it does.
struct Part {
  std::vector<TrackCommand*> before, shifted, after;
};

/// Range of segments, the last one included.
struct SegmentRange {
  int first = 0, last = 0;
};

/// Returns the hand that acts at the begin of a segment.
/// @throws std::invalid_argument if none does.
sim::HandName HandActingIn(const recording::EditableSegment& segment) {
  const auto hand =
      segment.commands.empty() ? std::nullopt : sim::HandOf(segment.commands.front().command);
  if (hand) return *hand;
  throw std::invalid_argument("segment " + std::to_string(segment.number) +
                              " is not the action of a hand");
}

Part PartOf(sim::HandName hand, const SegmentRange& range, std::vector<TrackCommand>* commands) {
  Part part;
  for (TrackCommand& one : *commands) {
    if (sim::HandOf(one.command.command) != hand) continue;
    const bool is_in_range = one.segment >= range.first && one.segment <= range.last;
    const bool is_action = sim::IsAction(one.command.command);
    if (!part.after.empty() || (!part.shifted.empty() && is_action && !is_in_range)) {
      part.after.push_back(&one);
    } else if (!part.shifted.empty() || (is_action && one.segment == range.first)) {
      // Motions in later segments of other hands still belong to the action.
      part.shifted.push_back(&one);
    } else {
      part.before.push_back(&one);
    }
  }
  return part;
}

double OffsetOf(const TrackCommand* one) { return static_cast<double>(one->command.offset); }

/// Returns the offset of the hand's next command after the part [ticks].
double OffsetAfter(const Part& part) {
  return part.after.empty() ? kMaxSeconds * sim::kTicksPerSecond : OffsetOf(part.after.front());
}

/// Returns how far the part can be shifted [ticks].
std::pair<double, double> RoomOf(const Part& part) {
  const double earliest = part.before.empty() ? 0 : OffsetOf(part.before.back());
  return {earliest - OffsetOf(part.shifted.front()),
          OffsetAfter(part) - OffsetOf(part.shifted.back())};
}

/// Cuts the commands into segments again, after those of the part have moved.
void CutAgain(const Part& part, std::vector<TrackCommand>* commands,
              recording::Demonstration* demonstration) {
  const std::uint64_t end =
      std::max(demonstration->duration(), part.shifted.back()->command.offset);
  demonstration->segments = CutAtActions(std::move(*commands), end);
}

}  // namespace

void PerformShift(const Shift& shift, const recording::EditableSegment& segment,
                  recording::Demonstration* demonstration) {
  const sim::HandName hand = HandActingIn(segment);
  std::vector<TrackCommand> commands = CommandsOf(*demonstration);
  const Part part = PartOf(hand, {shift.first, shift.last}, &commands);
  const auto [least, most] = RoomOf(part);
  const double ticks = std::round(shift.seconds * sim::kTicksPerSecond);
  if (!(ticks >= least && ticks <= most)) {
    // To hundredths, within the room.
    const double low = std::ceil(100 * least / sim::kTicksPerSecond) / 100 + 0.0;  // never -0
    const double high = std::floor(100 * most / sim::kTicksPerSecond) / 100;
    throw std::invalid_argument("it is shifted by " + NumberText(shift.seconds) + " s, expected " +
                                NumberText(low) + " to " + NumberText(high) +
                                " s: between what the " + std::string(ToString(hand)) +
                                " hand does before and after");
  }
  for (TrackCommand* one : part.shifted) {
    one->command.offset = static_cast<std::uint64_t>(OffsetOf(one) + ticks);
  }
  CutAgain(part, &commands, demonstration);
}

void PerformStretch(const Stretch& stretch, const recording::EditableSegment& segment,
                    recording::Demonstration* demonstration) {
  const sim::HandName hand = HandActingIn(segment);
  std::vector<TrackCommand> commands = CommandsOf(*demonstration);
  const Part part = PartOf(hand, {stretch.first, stretch.last}, &commands);
  const double begin = OffsetOf(part.shifted.front());
  const double length = OffsetOf(part.shifted.back()) - begin;
  if (begin + std::round(length * stretch.factor) > OffsetAfter(part)) {
    const double most = std::floor(100 * (OffsetAfter(part) - begin) / length) / 100;
    throw std::invalid_argument(
        "it takes " + NumberText(stretch.factor) + " times as long, expected at most " +
        NumberText(most) + ": up to what the " + std::string(ToString(hand)) + " hand does after");
  }
  for (TrackCommand* one : part.shifted) {
    const double since = std::round((OffsetOf(one) - begin) * stretch.factor);
    one->command.offset = static_cast<std::uint64_t>(begin + since);
  }
  CutAgain(part, &commands, demonstration);
}

}  // namespace smile::editing
