#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "sim/simulation_state.h"

namespace smile::sim {

/// The way back: the world as it was before each action of a hand, and as it was when one was
/// undone. About 2 kB per object and action; the oldest are forgotten beyond half a gigabyte.
class History {
 public:
  bool can_undo() const { return !befores_.empty(); }
  bool can_redo() const { return !undone_.empty(); }

  /// An action was carried out on this world. What had been undone cannot be redone any more.
  void Add(SimulationState before) {
    undone_.clear();
    num_bytes_ += SizeOf(before);
    befores_.push_back(std::move(before));
    while (num_bytes_ > kMaxBytes && befores_.size() > 1) {
      num_bytes_ -= SizeOf(befores_.front());
      befores_.pop_front();
    }
  }
  /// Something else was done, from where what had been undone no more follows.
  void ForgetUndone() { undone_.clear(); }

  /// The world before the last action; Redo() will answer `now`. Only if can_undo(). The reference
  /// holds until the next change.
  const SimulationState& Undo(SimulationState now) {
    undone_.push_back({.before = std::move(befores_.back()), .after = std::move(now)});
    befores_.pop_back();
    num_bytes_ -= SizeOf(undone_.back().before);
    return undone_.back().before;
  }
  /// The world as it was when the last undone action was undone. Only if can_redo().
  SimulationState Redo() {
    Undone redone = std::move(undone_.back());
    undone_.pop_back();
    num_bytes_ += SizeOf(redone.before);
    befores_.push_back(std::move(redone.before));
    return std::move(redone.after);
  }

 private:
  static constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

  struct Undone {
    SimulationState before, after;
  };

  /// Nearly: the rest is small and grows with it.
  static std::size_t SizeOf(const SimulationState& state) {
    return sizeof state + state.physics.state.size();
  }

  std::deque<SimulationState> befores_;
  std::vector<Undone> undone_;
  std::size_t num_bytes_ = 0;  ///< of befores_
};

}  // namespace smile::sim
