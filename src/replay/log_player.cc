#include "replay/log_player.h"

// Runs a log at the ticks that it names. A command in the log was applied between two ticks, after
// the tick with its number, so all commands of a tick are applied before the next one.

namespace smile::replay {

std::optional<LogPlayer::Failure> LogPlayer::ApplyNext(sim::Simulation* simulation) {
  const recording::LoggedCommand& logged = commands_[next_++];
  // It is counted as done even if it is refused: the caller reports the refusal and may continue.
  auto refusal = simulation->Apply(logged.command);
  if (!refusal) return std::nullopt;
  return Failure{logged, *std::move(refusal)};
}

bool LogPlayer::RunToTick(std::uint64_t tick, sim::Simulation* simulation,
                          const TickCallback& on_tick) {
  while (simulation->tick() < tick) {
    if (on_tick && !on_tick(simulation->tick())) return false;
    simulation->Tick();
  }
  return true;
}

std::optional<LogPlayer::Failure> LogPlayer::RunToStart(sim::Simulation* simulation,
                                                        const TickCallback& on_tick) {
  // By line and not by tick: commands of the recording may have the tick at which it began.
  while (next() != nullptr && next()->line <= start_.line) {
    if (!RunToTick(next()->tick, simulation, on_tick)) return std::nullopt;
    if (auto failure = ApplyNext(simulation)) return failure;
  }
  RunToTick(start_.tick, simulation, on_tick);
  return std::nullopt;
}

std::optional<LogPlayer::Failure> LogPlayer::ApplyDue(sim::Simulation* simulation) {
  while (IsDue(*simulation)) {
    if (auto failure = ApplyNext(simulation)) return failure;
  }
  return std::nullopt;
}

}  // namespace smile::replay
