#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "analysis/internal_trial.h"
#include "analysis/internal_trial_log.h"
#include "task/structure.h"

namespace smile::analysis {

/// Simulates a demonstration in other ways.
class Trials {
 public:
  /// @param recording  must outlive this.
  /// @throws as Analyze()
  Trials(const recording::Recording& recording, const AnalysisOptions& options);

  const std::vector<Subtask>& subtasks() const { return subtasks_; }
  /// Returns all goals of the demonstration.
  std::vector<GoalFinding> goals() const;
  std::size_t num_done() const { return num_done_; }

  const task::Structure& structure() const { return structure_; }

  /// Simulates several trials at the same time, those whose result is not known yet.
  /// @returns for each, why it fails to achieve what the demonstration did; nullopt if it achieves
  ///          it.
  /// @throws std::runtime_error if the progress callback returns false.
  std::vector<Harm> HarmsOf(const std::vector<Trial>& trials);
  std::vector<Harm> HarmsOf(const std::vector<SubtaskOrder>& orders);

  /// Removes the kept results.
  void Finish() { log_.Remove(); }

 private:
  Harm HarmOf(const Trial& trial) const;
  void Report(std::size_t done) const;

  const recording::Recording& recording_;
  const AnalysisOptions& options_;
  recording::Demonstration demonstration_;
  std::vector<Subtask> subtasks_;
  task::Structure demonstrated_;
  task::Structure structure_;  ///< without the ignored goals
  TrialLog log_;
  std::size_t num_done_ = 0;
};

}  // namespace smile::analysis
