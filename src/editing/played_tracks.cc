#include "editing/played_tracks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/action_summary.h"

namespace smile::editing {
PlayedTracks::PlayedTracks(const recording::Demonstration& demonstration, const KeptTracks& kept)
    : hands_(kept.hands),
      begin_(demonstration.start.tick +
             std::min(demonstration.duration(), static_cast<std::uint64_t>(std::llround(
                                                    kept.seconds * sim::kTicksPerSecond)))),
      conflicts_(demonstration) {
  for (recording::LoggedCommand& logged : demonstration.Schedule()) {
    // The past before the start has been run when the user begins.
    if (logged.line <= demonstration.start.line) continue;
    const auto hand = sim::HandOf(logged.command);
    commands_.push_back({.logged = std::move(logged), .is_kept = !hand || hands_.contains(*hand)});
  }
}

bool PlayedTracks::MustApplyNext() const {
  const TrackCommand& command = commands_[next_];
  // What the user has undone of the other hands does not come again.
  return command.is_kept || (command.logged.tick < begin_ && next_ == num_seen_);
}

void PlayedTracks::ApplyDue(sim::Simulation* simulation) {
  while (next_ < commands_.size() && commands_[next_].logged.tick <= simulation->tick()) {
    if (MustApplyNext()) ApplyNext(simulation);
    num_seen_ = std::max(num_seen_, ++next_);
    next_of_[simulation->history().current().id] = next_;
  }
}

void PlayedTracks::ApplyNext(sim::Simulation* simulation) {
  const auto& [logged, is_kept] = commands_[next_];
  conflicts_.Before(logged, *simulation);
  const auto refusal = simulation->Apply(logged.command);
  conflicts_.After(logged, refusal);
  if (!refusal && sim::IsAction(logged.command) && is_kept && logged.tick >= begin_) {
    played_.insert(simulation->history().current().id);
  }
}

void PlayedTracks::Follow(const sim::Simulation& simulation) {
  next_ = 0;
  // An action during which no command was due has no number of its own.
  for (const sim::Action& action : simulation.history().done()) {
    if (const std::size_t* next = next_of_.Find(action.id)) next_ = *next;
  }
  if (next_ < commands_.size()) conflicts_.ForgetFrom(commands_[next_].logged.line);
}

Json PlayedTracks::Describe() const {
  Json hands = Json::array();
  for (const sim::HandName hand : hands_) hands.push_back(ToString(hand));
  const auto num_left = std::count_if(
      commands_.begin() + static_cast<std::ptrdiff_t>(next_), commands_.end(),
      [](const TrackCommand& one) { return one.is_kept && sim::IsAction(one.logged.command); });
  return {{"hands", std::move(hands)},
          {"actions_left", num_left},
          {"conflicts", recording::ToJson(conflicts())}};
}

}  // namespace smile::editing
