#include "recording/markers.h"

#include <algorithm>
#include <iterator>

namespace smile::recording {

// One empty element before all changes: before the first command there are no markers.
MarkerTrack::MarkerTrack(const Recording& recording) : changes_(1) {
  for (const LoggedCommand& logged : recording.commands) {
    if (const auto* markers = std::get_if<sim::Markers>(&logged.command)) {
      changes_.emplace_back(logged.tick, markers->points_in_world);
    }
  }
}

const std::vector<Vector3>& MarkerTrack::At(std::uint64_t tick) const {
  // The element before the first later change; the initial element is earlier than any.
  const auto later =
      std::ranges::upper_bound(changes_, tick, {}, [](const auto& change) { return change.first; });
  return std::prev(later)->second;
}

}  // namespace smile::recording
