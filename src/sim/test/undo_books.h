#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "sim/per_action.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Independent record of a simulation's history, which is compared with it: the hash before each
/// action, including implied ones, and at each undo; the done and undone actions; the values that a
/// listener keeps per action.
class UndoBooks : public Listener {
 public:
  /// Add it as a listener before anything is done.
  explicit UndoBooks(const Simulation& simulation) : now_(simulation.state_hash()) {}

  void OnCommand(const Simulation& simulation, const Command& command) override {
    const ActionHistory& history = simulation.history();
    undone_.clear();
    if (IsAction(command)) {
      done_.push_back({.id = history.current().id, .before = now_});
      hashes_.Begin(history, now_);
    }
    const auto& commands = history.current().commands;
    EXPECT_EQ(commands.back(), (TimedCommand{simulation.tick(), command}));
    EXPECT_EQ(commands.size() == 1 && history.current().id != ActionId(), IsAction(command));
    now_ = simulation.state_hash();
    Compare(history);
  }
  void OnEvent(const Simulation& simulation, const Event& event) override {
    if (event.kind == EventKind::kCommandRefused) return;
    EXPECT_EQ(simulation.history().current().events.back(), event);
  }
  void OnMove(const Simulation& simulation, ActionId from, ActionId to) override {
    if (to < from) {
      NoteUndo(simulation, from);
    } else {
      NoteRedo(simulation, to);
    }
    EXPECT_EQ(simulation.history().current().id, to);
    now_ = simulation.state_hash();
    Compare(simulation.history());
  }
  void OnTick(const Simulation& simulation) override { now_ = simulation.state_hash(); }

  bool can_undo() const { return !done_.empty(); }
  bool can_redo() const { return !undone_.empty(); }
  int num_undone() const { return num_undone_; }
  int num_redone() const { return num_redone_; }

 private:
  struct Line {
    ActionId id;
    std::uint64_t before = 0, at_undo = 0;
  };

  void NoteUndo(const Simulation& simulation, ActionId from) {
    ASSERT_FALSE(done_.empty());
    EXPECT_EQ(done_.back().id, from);
    EXPECT_EQ(simulation.state_hash(), done_.back().before) << "after an undo";
    EXPECT_EQ(simulation.tick(), simulation.history().undone().front().tick);
    undone_.push_back(done_.back());
    undone_.back().at_undo = now_;
    done_.pop_back();
    ++num_undone_;
  }
  void NoteRedo(const Simulation& simulation, ActionId to) {
    ASSERT_FALSE(undone_.empty());
    EXPECT_EQ(undone_.back().id, to);
    EXPECT_EQ(simulation.state_hash(), undone_.back().at_undo) << "after a redo";
    done_.push_back(undone_.back());
    undone_.pop_back();
    ++num_redone_;
  }
  /// Checks that the cursor, the values per action and this record agree.
  void Compare(const ActionHistory& history) {
    ASSERT_EQ(history.done().size(), done_.size() + 1);
    ASSERT_EQ(history.undone().size(), undone_.size());
    EXPECT_EQ(history.can_undo(), can_undo());
    EXPECT_EQ(history.can_redo(), can_redo());
    for (std::size_t i = 0; i < done_.size(); ++i) CompareOne(history.done()[i + 1], done_[i]);
    for (std::size_t i = 0; i < undone_.size(); ++i) {
      CompareOne(history.undone()[i], undone_[undone_.size() - 1 - i]);
    }
  }
  void CompareOne(const Action& action, const Line& line) {
    EXPECT_EQ(action.id, line.id);
    ASSERT_NE(hashes_.Find(line.id), nullptr);
    EXPECT_EQ(*hashes_.Find(line.id), line.before);
  }

  std::uint64_t now_;
  std::vector<Line> done_;    ///< in order
  std::vector<Line> undone_;  ///< the last one is the next to be redone
  PerAction<std::uint64_t> hashes_;
  int num_undone_ = 0, num_redone_ = 0;
};

}  // namespace smile::sim
