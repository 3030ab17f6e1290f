#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/subtask.h"
#include "task/goals.h"
#include "texts/user_message.h"

namespace smile::analysis {

/// Finding about a subtask: what happens without it.
struct SubtaskFinding {
  Subtask subtask;
  /// Why the demonstration fails without it; nullopt if it achieves the same: the subtask is
  /// redundant.
  std::optional<texts::UserMessage> harm;
};

/// A subtask that must come before another one, and why.
struct Precedence {
  std::size_t before = 0, after = 0;  ///< indices of Analysis::subtasks
  texts::UserMessage harm;            ///< what happens in the opposite order
};

/// Goal of a demonstration, and whether it counted.
struct GoalFinding {
  task::Goal goal;
  bool counts = true;
};

/// Property that was changed before the demonstration was simulated again with the same actions.
struct PropertyFinding {
  enum class Property { kColor, kPlace };

  Property property = Property::kColor;
  std::string object;        ///< id; empty: all loose objects
  texts::UserMessage tried;  ///< in words; empty if it was not tried
  /// What happens then, or why it matters; nullopt: nothing.
  std::optional<texts::UserMessage> harm;
};

/// What matters in a demonstration: which subtasks, in which order, and which properties.
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
  /// Colors in scene order, then places. Only what was tried is known, not what lies in between.
  std::vector<PropertyFinding> properties;
  texts::UserMessage why_not_moved;  ///< why no other place was tried; empty if some were
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
  /// Keeps the results of simulations until all are done, so that an interrupted analysis
  /// continues; empty: nothing is kept. The result does not depend on interruptions.
  std::filesystem::path progress_file;
  std::string build;  ///< hash of the program, on which kept results depend
  std::function<void(std::string_view)> say = [](std::string_view) {};  ///< messages for people
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
/// Also simulates it with each object in another color, and with everything that is not fixed,
/// hands included, 100 mm away in four directions. Colors are not compared in that trial: they
/// matter only if the demonstrator said so.
///
/// Two subtasks are exchanged by moving the later one, with those between them that must precede
/// it, right before the earlier one.
/// @throws InputError if the recording has no commands or achieves nothing, or what it achieves
///         does not stand for 2 s; std::invalid_argument for ignored goals as
///         task::WithoutGoals(); std::runtime_error if `progress` returns false.
Analysis Analyze(const recording::Recording& recording, const AnalysisOptions& options);

}  // namespace smile::analysis
