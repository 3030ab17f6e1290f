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
  /// @param commands  in order.
  /// @param start     where the demonstration begins; see DemoInfo::start.
  LogPlayer(std::vector<recording::LoggedCommand> commands, const recording::HistoryPoint& start)
      : commands_(std::move(commands)), start_(start) {}

  /// A command that was carried out when it was recorded.
  struct Failure {
    recording::LoggedCommand command;
    sim::Refusal refusal;
  };

  /// Asked at every tick whether to go on.
  using GoesOn = std::function<bool(std::uint64_t tick)>;

  /// Runs a fresh simulation to where the demonstration begins. If it shall not go on, it is left
  /// before that tick.
  [[nodiscard]] std::optional<Failure> RunToStart(sim::Simulation* simulation,
                                                  const GoesOn& goes_on = {});
  /// Applies what is due at the present tick.
  [[nodiscard]] std::optional<Failure> ApplyDue(sim::Simulation* simulation);

  /// What comes next; nullptr after the last one.
  const recording::LoggedCommand* next() const {
    return next_ < commands_.size() ? &commands_[next_] : nullptr;
  }

 private:
  std::optional<Failure> ApplyNext(sim::Simulation* simulation);
  /// False if it shall not go on.
  static bool RunToTick(std::uint64_t tick, sim::Simulation* simulation, const GoesOn& goes_on);

  std::vector<recording::LoggedCommand> commands_;
  recording::HistoryPoint start_;
  std::size_t next_ = 0;
};

}  // namespace smile::replay
