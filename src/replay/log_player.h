#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "recording/recording.h"
#include "sim/simulation.h"

namespace smile::replay {

/// Runs the commands of a recording again, each at its tick.
class LogPlayer {
 public:
  /// Prepares a replay.
  /// @param commands  in order.
  /// @param start     beginning of the demonstration; see DemoInfo::start.
  LogPlayer(std::vector<recording::LoggedCommand> commands, const recording::HistoryPoint& start)
      : commands_(std::move(commands)), start_(start) {}

  /// A command that was executed when it was recorded, but is now refused.
  struct Failure {
    recording::LoggedCommand command;
    sim::Refusal refusal;
  };

  /// Called at each tick; returns false to stop.
  using TickCallback = std::function<bool(std::uint64_t tick)>;

  /// Runs a fresh simulation to the beginning of the demonstration, or to the tick at which it is
  /// stopped.
  [[nodiscard]] std::optional<Failure> RunToStart(sim::Simulation* simulation,
                                                  const TickCallback& on_tick = {});
  /// Applies the commands that are due at the present tick.
  [[nodiscard]] std::optional<Failure> ApplyDue(sim::Simulation* simulation);

  /// Returns true if the next command is due at the present tick.
  bool IsDue(const sim::Simulation& simulation) const {
    return next() != nullptr && next()->tick <= simulation.tick();
  }
  /// Applies the next command; there must be one.
  [[nodiscard]] std::optional<Failure> ApplyNext(sim::Simulation* simulation);
  /// Returns the next command; nullptr after the last one.
  const recording::LoggedCommand* next() const {
    return next_ < commands_.size() ? &commands_[next_] : nullptr;
  }

 private:
  /// Returns false if it was stopped.
  static bool RunToTick(std::uint64_t tick, sim::Simulation* simulation,
                        const TickCallback& on_tick);

  std::vector<recording::LoggedCommand> commands_;
  recording::HistoryPoint start_;
  std::size_t next_ = 0;
};

}  // namespace smile::replay
