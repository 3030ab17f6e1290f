#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/analysis.h"
#include "task/structure.h"

namespace smile::analysis {

/// Order of some or all subtasks of a demonstration.
using SubtaskOrder = std::vector<std::size_t>;

/// Simulates arrangements of the subtasks of a demonstration.
class Trials {
 public:
  /// @param recording  must outlive this.
  /// @throws as Analyze()
  Trials(const recording::Recording& recording, const AnalysisOptions& options);

  const std::vector<Subtask>& subtasks() const { return subtasks_; }
  /// Returns all goals of the demonstration.
  std::vector<GoalFinding> goals() const;
  std::size_t num_done() const { return num_done_; }

  /// Simulates several arrangements at the same time.
  /// @returns for each, why it fails to achieve what the demonstration did; nullopt if it achieves
  ///          it.
  /// @throws std::runtime_error if the progress callback returns false.
  std::vector<std::optional<std::string>> HarmsOf(const std::vector<SubtaskOrder>& orders);

 private:
  std::optional<std::string> HarmOf(const SubtaskOrder& order) const;
  void Report(std::size_t done) const;

  const recording::Recording& recording_;
  const AnalysisOptions& options_;
  recording::Demonstration demonstration_;
  std::vector<Subtask> subtasks_;
  task::Structure demonstrated_;
  task::Structure structure_;  ///< without the ignored goals
  std::size_t num_done_ = 0;
};

}  // namespace smile::analysis
