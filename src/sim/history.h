#pragma once

#include <vector>

#include "sim/simulation_state.h"

namespace smile::sim {

/// The way back: the world as it was before each action of a hand, and as it was when one was
/// undone. Holds about 2 kB per object and action.
class History {
 public:
  bool can_undo() const { return !befores_.empty(); }
  bool can_redo() const { return !undone_.empty(); }

  /// An action was carried out on this world. What had been undone cannot be redone any more.
  void Add(SimulationState before) {
    befores_.push_back(std::move(before));
    undone_.clear();
  }
  /// Something else was done, from where what had been undone no more follows.
  void ForgetUndone() { undone_.clear(); }

  /// The world before the last action; Redo() will answer `now`. Only if can_undo().
  SimulationState Undo(SimulationState now) {
    undone_.push_back({.before = std::move(befores_.back()), .after = std::move(now)});
    befores_.pop_back();
    return undone_.back().before;
  }
  /// The world as it was when the last undone action was undone. Only if can_redo().
  SimulationState Redo() {
    befores_.push_back(std::move(undone_.back().before));
    SimulationState after = std::move(undone_.back().after);
    undone_.pop_back();
    return after;
  }

 private:
  struct Undone {
    SimulationState before, after;
  };
  std::vector<SimulationState> befores_;
  std::vector<Undone> undone_;
};

}  // namespace smile::sim
