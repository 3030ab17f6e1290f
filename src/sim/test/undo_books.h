#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "sim/simulation.h"

namespace smile::sim {

/// Keeps the books a simulation has to keep, and compares: the hash before every action, also those
/// that a command implied, and at every undo.
class UndoBooks : public Listener {
 public:
  /// Add it as a listener before anything is done.
  explicit UndoBooks(const Simulation& simulation) : now_(simulation.state_hash()) {}

  void OnCommand(const Simulation& simulation, const Command& command) override {
    if (IsAction(command)) befores_.push_back(now_);
    undone_.clear();
    now_ = simulation.state_hash();
  }
  void OnUndo(const Simulation& simulation) override {
    ASSERT_FALSE(befores_.empty());
    EXPECT_EQ(simulation.state_hash(), befores_.back()) << "after an undo";
    undone_.push_back({befores_.back(), now_});
    befores_.pop_back();
    now_ = simulation.state_hash();
    ++num_undone_;
  }
  void OnRedo(const Simulation& simulation) override {
    ASSERT_FALSE(undone_.empty());
    EXPECT_EQ(simulation.state_hash(), undone_.back().after) << "after a redo";
    befores_.push_back(undone_.back().before);
    undone_.pop_back();
    now_ = simulation.state_hash();
    ++num_redone_;
  }
  void OnTick(const Simulation& simulation) override { now_ = simulation.state_hash(); }

  bool can_undo() const { return !befores_.empty(); }
  bool can_redo() const { return !undone_.empty(); }
  int num_undone() const { return num_undone_; }
  int num_redone() const { return num_redone_; }

 private:
  struct Undone {
    std::uint64_t before, after;
  };
  std::uint64_t now_;
  std::vector<std::uint64_t> befores_;
  std::vector<Undone> undone_;
  int num_undone_ = 0, num_redone_ = 0;
};

}  // namespace smile::sim
