#include "record/log_player.h"

namespace smile::record {

std::optional<LogPlayer::Failure> LogPlayer::ApplyNext(sim::Simulation* simulation) {
  const LoggedCommand& logged = commands_[next_++];
  auto refusal = simulation->Apply(logged.command);
  if (!refusal) return std::nullopt;
  return Failure{logged, *std::move(refusal)};
}

std::optional<LogPlayer::Failure> LogPlayer::RunToStart(sim::Simulation* simulation) {
  while (next() != nullptr && next()->line <= start_.line) {
    while (simulation->tick() < next()->tick) simulation->Tick();
    if (auto failure = ApplyNext(simulation)) return failure;
  }
  while (simulation->tick() < start_.tick) simulation->Tick();
  return std::nullopt;
}

std::optional<LogPlayer::Failure> LogPlayer::ApplyDue(sim::Simulation* simulation) {
  while (next() != nullptr && next()->tick <= simulation->tick()) {
    if (auto failure = ApplyNext(simulation)) return failure;
  }
  return std::nullopt;
}

}  // namespace smile::record
