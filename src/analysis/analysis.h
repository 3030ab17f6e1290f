#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/subtask.h"
#include "task/goals.h"

namespace smile::analysis {

/// Finding about a subtask: what happens without it.
struct SubtaskFinding {
  Subtask subtask;
  /// Why the demonstration fails without it; nullopt if it achieves the same: the subtask is
  /// redundant.
  std::optional<std::string> harm;
};

/// A subtask that must come before another one, and why.
struct Precedence {
  std::size_t before = 0, after = 0;  ///< indices of Analysis::subtasks
  std::string harm;                   ///< what happens in the opposite order
};

/// Goal of a demonstration, and whether it counted.
struct GoalFinding {
  task::Goal goal;
  bool counts = true;
};

/// What matters in a demonstration: which subtasks, and in which order.
struct Analysis {
  std::string demonstration;             ///< ContentOf() the recording
  std::vector<GoalFinding> goals;        ///< see task::GoalsOf()
  std::vector<SubtaskFinding> subtasks;  ///< in the demonstrated order
  /// Those that follow from no others, by `after`, then `before`. Subtasks that neither these nor a
  /// chain of these connect can be done in any order.
  std::vector<Precedence> precedences;
  /// Indices of subtasks that achieve the same by themselves, while none of them can be left out:
  /// what remains if redundant subtasks are left out one after the other, the last first.
  std::vector<std::size_t> sufficient;
  std::size_t num_simulations = 0;

  /// Returns whether a subtask must come before another one, directly or by a chain.
  bool MustPrecede(std::size_t before, std::size_t after) const;
  /// Returns for each subtask the number of subtasks in the longest chain that must come before it.
  std::vector<std::size_t> Levels() const;
};

/// Returns `1, 3 and 4` for the indices 0, 2 and 3: people count subtasks from 1.
std::string NumbersOf(const std::vector<std::size_t>& subtasks);

/// Returns a hash of a recording's scene, commands and path as 16 hexadecimal digits: recordings
/// that show the same have the same, whatever their pictures.
/// @throws InputError if a file is missing.
std::string ContentOf(const recording::Recording& recording);

struct AnalysisOptions {
  std::size_t num_threads = 1;       ///< at least 1
  std::vector<std::string> ignored;  ///< ids of goals that do not count, see task::GoalsOf()
  /// Called on the calling thread with numbers of simulations: finished ones, and an upper bound of
  /// all. Returning false ends the analysis.
  std::function<bool(std::size_t done, std::size_t at_most)> progress;
};

/// Simulates a demonstration again without each of its subtasks, and with each pair of subtasks in
/// the opposite order, and compares the results with what it achieved (task::StructureOf()),
/// without ignored goals. An arrangement achieves the same if no command is refused, and
/// task::CompareWith() finds everything achieved after 2 s at rest. The result does not depend on
/// the number of threads.
///
/// Two subtasks are exchanged by moving the later one, with those between them that must precede
/// it, right before the earlier one.
/// @throws InputError if the recording has no commands or achieves nothing, or what it achieves
///         does not stand for 2 s; std::invalid_argument for ignored goals as
///         task::WithoutGoals(); std::runtime_error if `progress` returns false.
Analysis Analyze(const recording::Recording& recording, const AnalysisOptions& options);

}  // namespace smile::analysis
