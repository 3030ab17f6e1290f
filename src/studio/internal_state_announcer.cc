#include "studio/internal_state_announcer.h"

#include <cmath>
#include <utility>

namespace smile::studio {
namespace {

/// Returns a state message without the values that change at every tick; differences in these alone
/// are not sent.
Json WithoutTime(Json state) {
  state.erase("tick");
  Json& recording = state["recording"];
  if (!recording.is_object()) return state;
  // The duration of a recording is sent once a second.
  recording["seconds"] = std::floor(recording["seconds"].get<double>());
  // Only the last segment grows; all others are constant.
  recording["segments"].back().erase("seconds");
  return state;
}

}  // namespace

std::optional<Json> StateAnnouncer::Update(Json state) {
  Json what_counts = WithoutTime(state);
  if (what_counts == sent_) return std::nullopt;
  sent_ = std::move(what_counts);
  return state;
}

}  // namespace smile::studio
