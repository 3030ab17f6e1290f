// Objects that leave the table are out of play.

#include "simulation_fixture.h"

namespace smile::sim {
namespace {

class FloorTest : public SimulationFixture {
 protected:
  FloorTest()
      : simulation_(MakeSimulation({BlockAt("a", {0, 0, 0.05}), BlockAt("b", {1.5, 0, 0.05})},
                                   /*with_robot=*/false)) {
    simulation_->AddListener(&ear_);
  }
  struct Ear : Listener {
    void OnEvent(const Simulation& simulation, const Event& event) override {
      if (event.kind == EventKind::kFell) fell.push_back({event.object, simulation.tick()});
    }
    std::vector<std::pair<std::string, std::uint64_t>> fell;
  };

  Ear ear_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(FloorTest, AFallIsReportedOnceAndResetByAnEarlierState) {
  const SimulationState start = simulation_->Save();
  TickSeconds(*simulation_, 2);
  ASSERT_EQ(ear_.fell.size(), 1u);
  EXPECT_EQ(ear_.fell[0].first, "b");
  EXPECT_NEAR(static_cast<double>(ear_.fell[0].second), 26, 1) << "0.9 m down take 0.43 s";
  EXPECT_EQ(simulation_->Apply(Grasp{.hand = HandName::kLeft, .object = "b"}),
            "'b' fell to the floor; undo restores it");

  const SimulationState end = simulation_->Save();
  const std::uint64_t hash = simulation_->state_hash();
  SimulationState forgetful = end;
  forgetful.tabletop.objects.Set(model::ObjectIndex(1), {});
  simulation_->Restore(forgetful);
  EXPECT_NE(simulation_->state_hash(), hash);

  simulation_->Restore(start);
  EXPECT_EQ(simulation_->Apply(Grasp{.hand = HandName::kLeft, .object = "b"}), std::nullopt);
  TickSeconds(*simulation_, 2);
  EXPECT_EQ(ear_.fell.size(), 1u) << "held, it does not fall";
  simulation_->Restore(end);
  TickSeconds(*simulation_, 1);
  EXPECT_EQ(ear_.fell.size(), 1u) << "it lies there already";
}

TEST_F(FloorTest, AnObjectHeldAgainstTheFloorFallsOnlyWhenReleased) {
  ASSERT_EQ(simulation_->Apply(Grasp{.hand = HandName::kLeft, .object = "b"}), std::nullopt);
  ASSERT_EQ(simulation_->Apply(MoveTo{.hand = HandName::kLeft, .p_WH = {1.5, 0, -1}}),
            std::nullopt);
  TickSeconds(*simulation_, 3);
  EXPECT_TRUE(ear_.fell.empty());
  ASSERT_EQ(simulation_->Apply(Release{.hand = HandName::kLeft}), std::nullopt);
  simulation_->Tick();
  EXPECT_EQ(ear_.fell.size(), 1u);
}

}  // namespace
}  // namespace smile::sim
