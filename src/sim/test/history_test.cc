// Undo and redo: any depth, at any time, exact.

#include <algorithm>

#include "event_counter.h"
#include "everything_scene.h"
#include "random_hands.h"
#include "simulation_fixture.h"
#include "undo_books.h"

namespace smile::sim {
namespace {

class HistoryProperty : public SimulationFixture, public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, HistoryProperty, testing::Range(21u, 24u));

TEST_P(HistoryProperty, EveryUndoAndRedoIsExact) {
  // Another scene, without the block beside the table.
  scene::SceneSpec other = EverythingScene::Make();
  other.objects.pop_back();
  EverythingScene::AddTools(&other);
  const Load load{std::make_shared<const scene::SceneSpec>(other)};
  Simulation simulation(EverythingScene::MakeWithTools());
  UndoBooks books(simulation);
  simulation.AddListener(&books);
  EventCounter counter;
  simulation.AddListener(&counter);
  RandomHands hands(GetParam(), /*changes_objects=*/true);
  std::mt19937 random(GetParam());
  for (int i = 0; i < 150; ++i) {
    if (const auto dice = random() % 8; dice == 0) {
      const bool was_possible = books.can_undo();
      ASSERT_EQ(simulation.Apply(Undo()).has_value(), !was_possible);
    } else if (dice == 1) {
      const bool was_possible = books.can_redo();
      ASSERT_EQ(simulation.Apply(Redo()).has_value(), !was_possible);
    } else if (dice == 2 && i % 4 == 0) {
      ASSERT_EQ(simulation.Apply(load), std::nullopt);
    } else {
      (void)simulation.Apply(hands.Next(simulation));
    }
    for (int tick = 0; tick < 4; ++tick) simulation.Tick();
  }
  EXPECT_GT(books.num_undone(), 5);
  EXPECT_GT(books.num_redone(), 0);
  EXPECT_GT(counter.num_events[EventKind::kUsed], 0);
  EXPECT_GT(counter.num_events[EventKind::kPressed], 0);
  // What is done in a scene leads to the present state, and ids and ticks ascend along the way.
  const std::vector<TimedCommand> way = simulation.history().CommandsDone();
  EXPECT_TRUE(std::ranges::is_sorted(way, {}, &TimedCommand::tick));
  EXPECT_TRUE(std::ranges::is_sorted(simulation.history().done(), {}, &Action::id));
  Simulation again(simulation.start_model());
  for (const TimedCommand& timed : way) {
    while (again.tick() < timed.tick) again.Tick();
    ASSERT_EQ(again.Apply(timed.command), std::nullopt);
  }
  while (again.tick() < simulation.tick()) again.Tick();
  EXPECT_EQ(again.state_hash(), simulation.state_hash());
  const auto actions = again.history().done().subspan(1);
  ASSERT_TRUE(std::ranges::equal(actions, simulation.history().done().last(actions.size()),
                                 [](const Action& a, const Action& b) {
                                   return a.commands == b.commands && a.events == b.events;
                                 }));

  while (simulation.history().can_undo()) ASSERT_EQ(simulation.Apply(Undo()), std::nullopt);
  EXPECT_FALSE(books.can_undo());
}

class HistoryTest : public SimulationFixture {};

TEST_F(HistoryTest, ListenersMayRefuseAndAreNotifiedOfTheReturn) {
  class Watcher : public Listener {
   public:
    std::optional<Refusal> Refuse(const Simulation&, const Command& command) override {
      if (std::holds_alternative<Redo>(command)) return "not while I watch";
      return std::nullopt;
    }
    void OnCommand(const Simulation&, const Command&) override { ++num_commands; }
    void OnMove(const Simulation& simulation, ActionId from, ActionId to) override {
      EXPECT_EQ(from.value, 1u);
      EXPECT_EQ(to, ActionId());
      tick_after_undo = simulation.tick();
    }
    int num_commands = 0;
    std::uint64_t tick_after_undo = 1;
  };
  Simulation simulation(EverythingScene::Make());
  Watcher watcher;
  simulation.AddListener(&watcher);
  EXPECT_EQ(*simulation.Apply(Undo()), "nothing to undo");
  ASSERT_FALSE(simulation.Apply(Grasp{.hand = HandName::kLeft, .object = "ball"}));
  simulation.Tick();
  ASSERT_FALSE(simulation.Apply(Undo()));
  EXPECT_EQ(watcher.num_commands, 1);
  EXPECT_EQ(watcher.tick_after_undo, 0u);
  EXPECT_EQ(*simulation.Apply(Redo()), "not while I watch");
  EXPECT_EQ(*simulation.Apply(StartRecording()), "no recorder is attached");
}

TEST_F(HistoryTest, ACommandAfterAnUndoDiscardsWhatWasUndone) {
  Simulation simulation(EverythingScene::Make());
  ASSERT_FALSE(simulation.Apply(Grasp{.hand = HandName::kLeft, .object = "ball"}));
  ASSERT_FALSE(simulation.Apply(Undo()));
  ASSERT_FALSE(simulation.Apply(Plane{.hand = HandName::kLeft, .angle_deg = 30}));
  EXPECT_EQ(*simulation.Apply(Redo()), "nothing to redo");
  ASSERT_FALSE(simulation.Apply(Grasp{.hand = HandName::kLeft, .object = "ball"}));
  const ActionHistory& history = simulation.history();
  ASSERT_EQ(history.done().size(), 2u);
  EXPECT_EQ(history.current().id.value, 2u) << "no id is used twice";
  EXPECT_EQ(history.done().front().commands.size(), 1u);
  EXPECT_EQ(history.CommandsDone().size(), 2u);
}

TEST_F(HistoryTest, ReportsWhetherAnythingIsMissing) {
  Simulation simulation(EverythingScene::Make());
  simulation.Tick();
  EXPECT_TRUE(simulation.history().is_complete());
  ASSERT_FALSE(simulation.Apply(Grasp{.hand = HandName::kLeft, .object = "ball"}));
  simulation.Restore(simulation.Save());
  EXPECT_FALSE(simulation.history().is_complete());
  EXPECT_EQ(simulation.history().current().tick, 1u);
  EXPECT_EQ(*simulation.Apply(Undo()), "nothing to undo");
}

TEST(ActionHistory, DropsTheOldestStatesButNoAction) {
  const auto state = [](std::uint64_t tick) {
    SimulationState large{.tick = tick};
    large.physics.state.resize(1 << 20);
    return large;
  };
  ActionHistory history(std::size_t{5} << 19);  // two states and a half
  for (std::uint64_t tick = 0; tick < 10; ++tick) {
    history.Begin(state(tick));
    history.Add({.tick = tick, .command = Release()});
  }
  EXPECT_EQ(history.done().size(), 11u);
  EXPECT_EQ(history.CommandsDone().size(), 10u);
  EXPECT_EQ(history.Undo(state(10)).tick, 9u);
  EXPECT_EQ(history.Undo(state(9)).tick, 8u);
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.Redo()->tick, 9u);
  EXPECT_EQ(history.Redo()->tick, 10u);
  EXPECT_TRUE(history.can_undo());

  // Discarded states make room for others.
  history.Undo(state(10));
  history.Begin(state(9));
  history.Undo(state(10));
  EXPECT_TRUE(history.can_undo());
}

SharedList<physics::Snapshot::BodyEntry> ListOf(physics::Snapshot::BodyEntry entry) {
  return SharedList(std::vector{std::move(entry)});
}

TEST(ActionHistory, CountsWhatStatesShareOnce) {
  const auto body = std::make_shared<const std::vector<std::byte>>(1 << 20);
  const auto state = [&body](std::uint64_t tick) {
    SimulationState saved{.tick = tick};
    saved.physics.bodies = ListOf({physics::BodyId{1}, nullptr, body});
    return saved;
  };
  ActionHistory history(std::size_t{3} << 19);  // one body and a half
  for (std::uint64_t tick = 0; tick < 100; ++tick) history.Begin(state(tick));
  for (std::uint64_t tick = 100; tick > 0; --tick) {
    ASSERT_TRUE(history.can_undo()) << tick;
    EXPECT_EQ(history.Undo(state(tick)).tick, tick - 1);
  }
}

TEST(ActionHistory, AStateThatRemainsHasWhatItSharedWithDiscardedOnes) {
  const auto first = std::make_shared<const std::vector<std::byte>>(1 << 20);
  const auto second = std::make_shared<const std::vector<std::byte>>(1 << 20);
  const auto state = [](const auto& body) {
    SimulationState saved;
    saved.physics.bodies = ListOf({physics::BodyId{1}, nullptr, body});
    return saved;
  };
  ActionHistory history(std::size_t{3} << 19);
  history.Begin(state(first));
  history.Begin(state(first));
  history.Begin(state(second));
  // Discarding the first state freed nothing, since the second one has the same body.
  history.Undo(state(second));
  EXPECT_FALSE(history.can_undo());
}

TEST(ActionHistory, ARedoDiscardsWhatHappenedSinceTheUndo) {
  ActionHistory history;
  const auto event = [](const char* object) {
    return Event{.kind = EventKind::kFell, .object = object};
  };
  history.Add(event("a"));
  history.Begin({});
  history.Add(event("b"));
  history.Undo({});
  history.Add(event("c"));
  EXPECT_EQ(history.current().events, (std::vector{event("a"), event("c")}));
  (void)history.Redo();
  EXPECT_EQ(history.current().events, (std::vector{event("b")}));
  EXPECT_EQ(history.done().front().events, (std::vector{event("a")}));
}

TEST(PerAction, ValuesOutliveTheUndoButNotTheDiscard) {
  ActionHistory history;
  PerAction<int> values;
  history.Begin({});
  values.Begin(history, 1);
  history.Begin({});
  values.Begin(history, 2);
  history.Undo({});
  ASSERT_NE(values.Find(history.undone().front().id), nullptr);
  history.Begin({});
  values.Begin(history, 3);
  EXPECT_EQ(values.size(), 2u);
  EXPECT_EQ(*values.Find(history.current().id), 3);
  EXPECT_EQ(values.Find({2}), nullptr);
}

}  // namespace
}  // namespace smile::sim
