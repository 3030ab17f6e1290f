#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/demonstration.h"
#include "recording/recording.h"
#include "sim/action_summary.h"

namespace smile::analysis {

/// Subtask of a demonstration: consecutive actions from one moment at which no hand holds anything
/// to the next. Taking, carrying and releasing an object is one subtask, whatever was fastened or
/// triggered in between; what two hands do at the same time is one subtask, too.
struct Subtask {
  int first = 0, last = 0;           ///< segments, by their numbers in the recording
  std::uint64_t begin = 0, end = 0;  ///< [ticks] from the start of the demonstration
  std::vector<std::string> actions;  ///< in words: `right hand takes b03`
  /// Ids of the objects, parts, controls and tools of its actions, each once, in their order.
  std::vector<std::string> objects;
  /// What came of it, in words: all actions but those that take an object, unless it is still held.
  std::string words;
  /// The actions that `words` tells of.
  std::vector<sim::ActionSummary> parts;

  bool operator==(const Subtask&) const = default;
};

/// Cuts the recording's path into subtasks. What happened before the first action is in none.
/// @throws InputError if the recording's trace cannot be read, or no hand did anything.
std::vector<Subtask> SubtasksOf(const recording::Recording& recording);

/// Returns the demonstration with only these subtasks, in this order. What happened before the
/// first action stays at the beginning.
/// @param order  indices of `subtasks`, each at most once.
recording::Demonstration Arranged(const recording::Demonstration& demonstration,
                                  const std::vector<Subtask>& subtasks,
                                  const std::vector<std::size_t>& order);

}  // namespace smile::analysis
