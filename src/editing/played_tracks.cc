#include "editing/played_tracks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "sim/action_summary.h"

namespace smile::editing {
namespace {

/// Returns `left hand: grasp`.
std::string WordsOf(const sim::Command& command) {
  const auto hand = sim::HandOf(command);
  const std::string whose = hand ? std::string(ToString(*hand)) + " hand: " : "";
  return whose + std::visit([](const auto& one) { return one.kName.name; }, command);
}

}  // namespace

PlayedTracks::PlayedTracks(const recording::Demonstration& demonstration, const KeptTracks& kept)
    : hands_(kept.hands),
      begin_(demonstration.start.tick +
             std::min(demonstration.duration(), static_cast<std::uint64_t>(std::llround(
                                                    kept.seconds * sim::kTicksPerSecond)))) {
  for (recording::LoggedCommand& logged : demonstration.Schedule()) {
    // The past before the start has been run when the user begins.
    if (logged.line <= demonstration.start.line) continue;
    const auto hand = sim::HandOf(logged.command);
    commands_.push_back({.tick = logged.tick,
                         .command = std::move(logged.command),
                         .is_kept = !hand || hands_.contains(*hand)});
  }
}

bool PlayedTracks::MustApplyNext() const {
  const TrackCommand& command = commands_[next_];
  // What the user has undone of the other hands does not come again.
  return command.is_kept || (command.tick < begin_ && next_ == num_seen_);
}

void PlayedTracks::ApplyDue(sim::Simulation* simulation) {
  while (next_ < commands_.size() && commands_[next_].tick <= simulation->tick()) {
    if (MustApplyNext()) ApplyNext(simulation);
    num_seen_ = std::max(num_seen_, ++next_);
    next_of_[simulation->history().current().id] = next_;
  }
}

void PlayedTracks::ApplyNext(sim::Simulation* simulation) {
  const TrackCommand& next = commands_[next_];
  if (auto refusal = simulation->Apply(next.command)) {
    // A grasp that is refused makes the moves after it impossible, too: the first one tells why.
    const bool is_told = !skipped_.empty() && skipped_.back().reason == *refusal;
    if (!is_told) skipped_.push_back({next_, *std::move(refusal)});
  } else if (sim::IsAction(next.command) && next.is_kept && next.tick >= begin_) {
    played_.insert(simulation->history().current().id);
  }
}

void PlayedTracks::Follow(const sim::Simulation& simulation) {
  next_ = 0;
  // An action during which no command was due has no number of its own.
  for (const sim::Action& action : simulation.history().done()) {
    if (const std::size_t* next = next_of_.Find(action.id)) next_ = *next;
  }
  std::erase_if(skipped_, [this](const Skipped& skipped) { return skipped.command >= next_; });
}

Json PlayedTracks::Describe() const {
  Json hands = Json::array(), skipped = Json::array();
  for (const sim::HandName hand : hands_) hands.push_back(ToString(hand));
  for (const Skipped& one : skipped_) {
    skipped.push_back(
        {{"command", WordsOf(commands_[one.command].command)}, {"reason", one.reason}});
  }
  const auto num_left = std::count_if(
      commands_.begin() + static_cast<std::ptrdiff_t>(next_), commands_.end(),
      [](const TrackCommand& one) { return one.is_kept && sim::IsAction(one.command); });
  return {{"hands", std::move(hands)}, {"actions_left", num_left}, {"skipped", std::move(skipped)}};
}

}  // namespace smile::editing
