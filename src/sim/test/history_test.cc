// Undo and redo: any depth, at any time, exact.

#include "everything_scene.h"
#include "random_hands.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

class HistoryProperty : public SimulationFixture, public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, HistoryProperty, testing::Range(21u, 24u));

/// Keeps the books a simulation has to keep: the hash before every action, implied ones too.
struct Bookkeeper : Listener {
  void OnCommand(const Simulation& simulation, const Command& command) override {
    if (IsAction(command)) befores.push_back(now);
    now = simulation.state_hash();
  }
  std::uint64_t now = 0;  ///< of the simulation before what it does next
  std::vector<std::uint64_t> befores;
};

TEST_P(HistoryProperty, EveryUndoAndRedoIsExact) {
  Simulation simulation(EverythingScene::Make());
  RandomHands hands(GetParam());
  std::mt19937 random(GetParam());
  struct Undone {
    std::uint64_t before, after;
  };
  Bookkeeper bookkeeper;
  simulation.AddListener(&bookkeeper);
  std::vector<std::uint64_t>& befores = bookkeeper.befores;
  std::vector<Undone> undone;
  int num_undone = 0, num_redone = 0;
  for (int i = 0; i < 150; ++i) {
    const std::uint64_t now = simulation.state_hash();
    if (const auto dice = random() % 8; dice == 0) {
      ASSERT_EQ(simulation.Apply(Undo()).has_value(), befores.empty());
      if (befores.empty()) continue;
      undone.push_back({befores.back(), now});
      befores.pop_back();
      ASSERT_EQ(simulation.state_hash(), undone.back().before) << "undo at step " << i;
      ++num_undone;
    } else if (dice == 1) {
      ASSERT_EQ(simulation.Apply(Redo()).has_value(), undone.empty());
      if (undone.empty()) continue;
      befores.push_back(undone.back().before);
      ASSERT_EQ(simulation.state_hash(), undone.back().after) << "redo at step " << i;
      undone.pop_back();
      ++num_redone;
    } else {
      bookkeeper.now = now;
      if (!simulation.Apply(hands.Next(simulation))) undone.clear();
    }
    for (int tick = 0; tick < 4; ++tick) simulation.Tick();
  }
  EXPECT_GT(num_undone, 5);
  EXPECT_GT(num_redone, 0);
  while (simulation.can_undo()) {
    ASSERT_EQ(simulation.Apply(Undo()), std::nullopt);
    EXPECT_EQ(simulation.state_hash(), befores.back());
    befores.pop_back();
  }
  EXPECT_TRUE(befores.empty());
}

class HistoryTest : public SimulationFixture {};

TEST_F(HistoryTest, WhoeverWatchesMayForbidAndIsToldOfTheReturn) {
  class Watcher : public Listener {
   public:
    std::optional<Refusal> Refuse(const Simulation&, const Command& command) override {
      if (std::holds_alternative<Redo>(command)) return "not while I watch";
      return std::nullopt;
    }
    void OnCommand(const Simulation&, const Command&) override { ++num_commands; }
    void OnUndo(const Simulation& simulation) override { tick_after_undo = simulation.tick(); }
    int num_commands = 0;
    std::uint64_t tick_after_undo = 1;
  };
  Simulation simulation(EverythingScene::Make());
  Watcher watcher;
  simulation.AddListener(&watcher);
  EXPECT_EQ(*simulation.Apply(Undo()), "there is nothing to undo");
  ASSERT_FALSE(simulation.Apply(Grasp{.hand = HandName::kLeft, .object = "ball"}));
  simulation.Tick();
  ASSERT_FALSE(simulation.Apply(Undo()));
  EXPECT_EQ(watcher.num_commands, 1);
  EXPECT_EQ(watcher.tick_after_undo, 0u);
  EXPECT_EQ(*simulation.Apply(Redo()), "not while I watch");
  EXPECT_EQ(*simulation.Apply(StartRecording()), "nobody records this simulation");
}

}  // namespace
}  // namespace smile::sim
