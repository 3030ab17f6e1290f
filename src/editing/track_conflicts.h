#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "recording/conflicts.h"
#include "recording/demonstration.h"
#include "sim/simulation.h"

namespace smile::editing {

/// Collects what hands do not find as it was when they act again: commands that are refused,
/// objects that another hand holds now, and objects that are not where they were taken. An action
/// and what follows from it, such as the moves after a refused grasp, have one conflict: its first.
class TrackConflicts {
 public:
  explicit TrackConflicts(const recording::Demonstration& demonstration)
      : start_tick_(demonstration.start.tick), grasped_(demonstration.grasped) {}

  /// To be called before a command is applied.
  void Before(const recording::LoggedCommand& logged, const sim::Simulation& simulation);
  /// To be called after it was applied, or refused.
  void After(const recording::LoggedCommand& logged, const std::optional<sim::Refusal>& refusal);
  /// Forgets those of the command at this line and later ones, which will be done again.
  void ForgetFrom(std::size_t line);

  /// Returns all, by time.
  std::vector<recording::Conflict> conflicts() const;

 private:
  struct OfCommand {
    std::size_t line = 0;
    recording::Conflict conflict;
  };
  /// Returns why a hand does not find what it found when it was recorded.
  std::optional<texts::UserMessage> ReasonOf(const recording::LoggedCommand& logged,
                                             const sim::Simulation& simulation) const;

  std::uint64_t start_tick_;
  std::map<std::size_t, recording::TracePose> grasped_;  ///< see Demonstration
  std::vector<OfCommand> found_;
  std::optional<texts::UserMessage> found_before_;  ///< of the command that is being applied
  /// Whose last action has a conflict.
  std::set<std::optional<sim::HandName>> in_conflict_;
};

}  // namespace smile::editing
