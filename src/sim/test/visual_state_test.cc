// The visual state that is kept and the one that is computed from everything are equal, whatever
// happens between two queries.

#include "everything_scene.h"
#include "random_hands.h"
#include "simulation_fixture.h"
#include "visual_state_watcher.h"

namespace smile::sim {
namespace {

class VisualStateProperty : public SimulationFixture,
                            public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, VisualStateProperty, testing::Range(31u, 35u));

TEST_P(VisualStateProperty, EqualsTheComputedOne) {
  const Load load{std::make_shared<const scene::SceneSpec>(EverythingScene::Make())};
  Simulation simulation(EverythingScene::MakeWithTools(), RobotPlacement{.model = Baxter()});
  // Queried after each change, or after many.
  VisualStateWatcher watcher(GetParam(), /*mean_gap=*/GetParam() % 2 == 0 ? 1 : 40);
  simulation.AddListener(&watcher);
  RandomHands hands(GetParam(), /*changes_objects=*/true);
  std::mt19937 random(GetParam());
  std::vector<SimulationState> saved;
  for (int i = 0; i < 150; ++i) {
    const auto dice = random() % 12;
    if (dice < 2) {
      (void)simulation.Apply(Undo());
    } else if (dice == 2) {
      (void)simulation.Apply(Redo());
    } else if (dice == 3 && i % 4 == 0) {
      ASSERT_EQ(simulation.Apply(load), std::nullopt);
    } else if (dice == 4) {
      saved.push_back(simulation.Save());
    } else if (dice == 5 && !saved.empty()) {
      simulation.Restore(saved[random() % saved.size()]);
    } else if (dice == 6) {
      const double speed = 0.2 * static_cast<double>(random() % 3) - 0.2;
      ASSERT_EQ(simulation.Apply(JointVelocities{.arms = {{"left", {speed, 0, 0, 0, 0, 0, 0}}}}),
                std::nullopt);
    } else {
      (void)simulation.Apply(hands.Next(simulation));
    }
    // Now and then long enough for objects to fall asleep and to be left out of the physics.
    for (int tick = i % 10 == 9 ? 150 : 3; tick > 0; --tick) simulation.Tick();
    if (HasFailure()) return;
  }
  EXPECT_GT(watcher.num_comparisons(), 20);
}

class VisualStateTest : public SimulationFixture {
 protected:
  /// Returns a simulation of block `a` and of block `b`, which a hand holds, so that it never
  /// rests.
  static std::unique_ptr<Simulation> MakeBusySimulation(double height) {
    auto simulation =
        MakeSimulation({BlockAt("a", {0, 0, height}), BlockAt("b", {0.6, 0, 0.05})}, false);
    EXPECT_EQ(simulation->Apply(Grasp{.hand = HandName::kRight, .object = "b"}), std::nullopt);
    return simulation;
  }
  static Vector3 PositionShown(const Simulation& simulation, std::string_view id) {
    const model::Model& model = simulation.model();
    const model::FrameIndex frame = model.frame_of(*model.FindObject(id));
    return simulation.visual_state().poses[frame].translation();
  }
  static bool IsAwake(const Simulation& simulation, std::string_view id) {
    return simulation.physics().body(simulation.tabletop().Find(id)->body).is_awake();
  }
};

TEST_F(VisualStateTest, ShowsWhereAnObjectFellAsleepWithoutAQuery) {
  const auto simulation = MakeBusySimulation(/*height=*/0.4);
  EXPECT_EQ(PositionShown(*simulation, "a").z(), 0.4);
  TickSeconds(*simulation, 5);
  ASSERT_FALSE(IsAwake(*simulation, "a"));
  EXPECT_NEAR(PositionShown(*simulation, "a").z(), 0.05, 1e-3);
  EXPECT_EQ(simulation->visual_state(), ComputedVisualState(*simulation));
}

TEST_F(VisualStateTest, ShowsASleepingObjectWhereAnUndoPutsIt) {
  const auto simulation = MakeBusySimulation(/*height=*/0.05);
  TickSeconds(*simulation, 3);
  ASSERT_FALSE(IsAwake(*simulation, "a"));
  const Vector3 before = PositionShown(*simulation, "a");
  using enum HandName;
  ASSERT_EQ(simulation->Apply(Grasp{.hand = kLeft, .object = "a"}), std::nullopt);
  ASSERT_EQ(simulation->Apply(MoveTo{.hand = kLeft, .p_WH = {-0.4, 0.2, 0.06}}), std::nullopt);
  TickSeconds(*simulation, 3);
  ASSERT_EQ(simulation->Apply(Release{.hand = kLeft}), std::nullopt);
  TickSeconds(*simulation, 5);
  ASSERT_FALSE(IsAwake(*simulation, "a"));
  const Vector3 after = PositionShown(*simulation, "a");
  EXPECT_GT((after - before).norm(), 0.2);
  // It sleeps in both places, and is left out of the physics again before the next query.
  for (int i = 0; i < 2; ++i) ASSERT_EQ(simulation->Apply(Undo()), std::nullopt);
  EXPECT_FALSE(IsAwake(*simulation, "a"));
  TickSeconds(*simulation, 3);
  EXPECT_EQ(PositionShown(*simulation, "a"), before);
  EXPECT_EQ(simulation->visual_state(), ComputedVisualState(*simulation));
}

TEST_F(VisualStateTest, HidesWhatIsDestroyedUntilAnUndo) {
  const auto simulation =
      MakeSimulation({BlockAt("a", {0, 0, 0.05}), BlockAt("b", {0.5, 0, 0.05})}, false);
  TickSeconds(*simulation, 3);
  const scene::VisualState before = simulation->visual_state();
  ASSERT_EQ(simulation->Apply(Remove{.object = "a"}), std::nullopt);
  const scene::VisualState without = simulation->visual_state();
  EXPECT_NE(without, before);
  EXPECT_EQ(without, ComputedVisualState(*simulation));
  ASSERT_EQ(simulation->Apply(Undo()), std::nullopt);
  EXPECT_EQ(simulation->visual_state(), before);
  // Removed and returned between two queries.
  ASSERT_EQ(simulation->Apply(Redo()), std::nullopt);
  ASSERT_EQ(simulation->Apply(Undo()), std::nullopt);
  EXPECT_EQ(simulation->visual_state(), before);
}

}  // namespace
}  // namespace smile::sim
