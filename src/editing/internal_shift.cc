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

Part PartOf(sim::HandName hand, const Shift& shift, std::vector<TrackCommand>* commands) {
  Part part;
  for (TrackCommand& one : *commands) {
    if (sim::HandOf(one.command.command) != hand) continue;
    const bool is_in_range = one.segment >= shift.first && one.segment <= shift.last;
    const bool is_action = sim::IsAction(one.command.command);
    if (!part.after.empty() || (!part.shifted.empty() && is_action && !is_in_range)) {
      part.after.push_back(&one);
    } else if (!part.shifted.empty() || (is_action && one.segment == shift.first)) {
      // Motions in later segments of other hands still belong to the action.
      part.shifted.push_back(&one);
    } else {
      part.before.push_back(&one);
    }
  }
  return part;
}

/// Returns how far the part can be shifted [ticks].
std::pair<double, double> RoomOf(const Part& part) {
  const auto offset = [](const TrackCommand* one) {
    return static_cast<double>(one->command.offset);
  };
  const double earliest = part.before.empty() ? 0 : offset(part.before.back());
  const double latest =
      part.after.empty() ? kMaxSeconds * sim::kTicksPerSecond : offset(part.after.front());
  return {earliest - offset(part.shifted.front()), latest - offset(part.shifted.back())};
}

}  // namespace

void PerformShift(const Shift& shift, const recording::EditableSegment& segment,
                  recording::Demonstration* demonstration) {
  const auto hand =
      segment.commands.empty() ? std::nullopt : sim::HandOf(segment.commands.front().command);
  if (!hand) {
    throw std::invalid_argument("segment " + std::to_string(shift.first) +
                                " is not the action of a hand");
  }
  std::vector<TrackCommand> commands = CommandsOf(*demonstration);
  const Part part = PartOf(*hand, shift, &commands);
  const auto [least, most] = RoomOf(part);
  const double ticks = std::round(shift.seconds * sim::kTicksPerSecond);
  if (!(ticks >= least && ticks <= most)) {
    // To hundredths, within the room.
    const double low = std::ceil(100 * least / sim::kTicksPerSecond) / 100 + 0.0;  // never -0
    const double high = std::floor(100 * most / sim::kTicksPerSecond) / 100;
    throw std::invalid_argument("it is shifted by " + NumberText(shift.seconds) + " s, expected " +
                                NumberText(low) + " to " + NumberText(high) +
                                " s: between what the " + std::string(ToString(*hand)) +
                                " hand does before and after");
  }
  for (TrackCommand* one : part.shifted) {
    one->command.offset =
        static_cast<std::uint64_t>(static_cast<double>(one->command.offset) + ticks);
  }
  const std::uint64_t end =
      std::max(demonstration->duration(), part.shifted.back()->command.offset);
  demonstration->segments = CutAtActions(std::move(commands), end);
}

}  // namespace smile::editing
