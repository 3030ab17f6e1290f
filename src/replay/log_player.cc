#include "replay/log_player.h"

namespace smile::replay {

std::optional<LogPlayer::Failure> LogPlayer::ApplyNext(sim::Simulation* simulation) {
  const recording::LoggedCommand& logged = commands_[next_++];
  auto refusal = simulation->Apply(logged.command);
  if (!refusal) return std::nullopt;
  return Failure{logged, *std::move(refusal)};
}

bool LogPlayer::RunToTick(std::uint64_t tick, sim::Simulation* simulation, const GoesOn& goes_on) {
  while (simulation->tick() < tick) {
    if (goes_on && !goes_on(simulation->tick())) return false;
    simulation->Tick();
  }
  return true;
}

std::optional<LogPlayer::Failure> LogPlayer::RunToStart(sim::Simulation* simulation,
                                                        const GoesOn& goes_on) {
  while (next() != nullptr && next()->line <= start_.line) {
    if (!RunToTick(next()->tick, simulation, goes_on)) return std::nullopt;
    if (auto failure = ApplyNext(simulation)) return failure;
  }
  RunToTick(start_.tick, simulation, goes_on);
  return std::nullopt;
}

std::optional<LogPlayer::Failure> LogPlayer::ApplyDue(sim::Simulation* simulation) {
  while (next() != nullptr && next()->tick <= simulation->tick()) {
    if (auto failure = ApplyNext(simulation)) return failure;
  }
  return std::nullopt;
}

}  // namespace smile::replay
