// Undo and redo: any depth, at any time, exact.

#include "everything_scene.h"
#include "random_hands.h"
#include "simulation_fixture.h"
#include "undo_books.h"

namespace smile::sim {
namespace {

class HistoryProperty : public SimulationFixture, public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, HistoryProperty, testing::Range(21u, 24u));

TEST_P(HistoryProperty, EveryUndoAndRedoIsExact) {
  Simulation simulation(EverythingScene::Make());
  UndoBooks books(simulation);
  simulation.AddListener(&books);
  RandomHands hands(GetParam());
  std::mt19937 random(GetParam());
  for (int i = 0; i < 150; ++i) {
    if (const auto dice = random() % 8; dice == 0) {
      const bool was_possible = books.can_undo();
      ASSERT_EQ(simulation.Apply(Undo()).has_value(), !was_possible);
    } else if (dice == 1) {
      const bool was_possible = books.can_redo();
      ASSERT_EQ(simulation.Apply(Redo()).has_value(), !was_possible);
    } else {
      (void)simulation.Apply(hands.Next(simulation));
    }
    for (int tick = 0; tick < 4; ++tick) simulation.Tick();
  }
  EXPECT_GT(books.num_undone(), 5);
  EXPECT_GT(books.num_redone(), 0);
  while (simulation.can_undo()) ASSERT_EQ(simulation.Apply(Undo()), std::nullopt);
  EXPECT_FALSE(books.can_undo());
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
