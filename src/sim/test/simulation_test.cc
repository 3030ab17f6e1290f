#include "sim/simulation.h"

#include <cmath>

#include "base/state_hash.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

class SimulationTest : public SimulationFixture {
 protected:
  /// The arm moves with a hand carrying and a block falling: everything at once.
  static std::uint64_t RunBusySecond(Simulation& simulation, std::uint64_t first_tick) {
    StateHash hash;
    for (int i = 0; i < 60; ++i) {
      if (i % 10 == 0) {
        simulation.Apply(JointVelocities{
            .arms = {{"left",
                      std::vector<double>(7, 0.3 * std::sin(static_cast<double>(first_tick) + i))}},
            .grippers = {{"left", i % 20 == 0 ? -0.1 : 0.1}, {"right", -0.05}},
            .head = 0.2});
      }
      if (i == 20) simulation.Apply(Rotate{.angles_deg = {10, 0, 20}});
      if (i == 30) simulation.Apply(Release{});
      if (i == 40) simulation.Apply(Grasp{.object = "c"});
      if (i == 41) simulation.Apply(MoveTo{.p_WH = {0.05, -0.1, 0.2}});
      simulation.Tick();
      hash.Add(simulation.state_hash());
    }
    return hash.value();
  }
  static std::unique_ptr<Simulation> MakeBusy() {
    auto simulation =
        MakeSimulation({BlockAt("a", {-0.2, -0.2, 0.05}), BlockAt("b", {-0.2, -0.2, 0.15}),
                        BlockAt("c", {0.1, -0.1, 0.4})},
                       /*with_robot=*/true);
    simulation->Apply(Grasp{.object = "b"});
    simulation->Apply(MoveTo{.p_WH = {0.1, -0.1, 0.3}});
    RunBusySecond(*simulation, 0);
    return simulation;
  }
};

TEST_F(SimulationTest, SecondsAreTicks) {
  auto simulation = MakeSimulation({}, false);
  TickSeconds(*simulation, 5);
  EXPECT_EQ(simulation->tick(), 300u);
  EXPECT_DOUBLE_EQ(simulation->seconds(), 5.0);
}

TEST_F(SimulationTest, SameCommandsGiveTheSameBits) {
  EXPECT_EQ(MakeBusy()->state_hash(), MakeBusy()->state_hash());
}

TEST_F(SimulationTest, ContinuesExactlyAfterRestoringInPlaceAndElsewhere) {
  auto simulation = MakeBusy();
  const SimulationState state = simulation->Save();
  const std::uint64_t hash = simulation->state_hash();
  const std::uint64_t later_hash = RunBusySecond(*simulation, 1);

  simulation->Restore(state);
  EXPECT_EQ(simulation->state_hash(), hash);
  EXPECT_EQ(RunBusySecond(*simulation, 1), later_hash);

  auto elsewhere = MakeBusy();
  TickSeconds(*elsewhere, 0.5);
  elsewhere->Restore(state);
  EXPECT_EQ(RunBusySecond(*elsewhere, 1), later_hash);
}

TEST_F(SimulationTest, ARefusedCommandChangesNothingAndIsReported) {
  struct Ear : Listener {
    void OnCommand(const Simulation&, const Command&) override { ++commands; }
    void OnEvent(const Simulation&, const Event& event) override { reason = event.reason; }
    int commands = 0;
    std::string reason;
  } ear;
  auto simulation = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, false);
  simulation->AddListener(&ear);
  const std::uint64_t hash = simulation->state_hash();
  EXPECT_EQ(simulation->Apply(MoveTo{}), "the hand 'any' holds nothing");
  EXPECT_EQ(simulation->Apply(JointVelocities{}), "there is no robot in this simulation");
  EXPECT_EQ(ear.commands, 0);
  EXPECT_EQ(ear.reason, "there is no robot in this simulation");
  EXPECT_EQ(simulation->state_hash(), hash);
}

TEST_F(SimulationTest, HidingTheRobotChangesNoPhysics) {
  auto shown = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, true);
  auto hidden = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, true);
  hidden->Apply(ShowRobot{.is_shown = false});
  TickSeconds(*shown, 0.5);
  TickSeconds(*hidden, 0.5);
  EXPECT_EQ(shown->state_hash(), hidden->state_hash());
  EXPECT_FALSE(hidden->is_robot_shown());
}

TEST_F(SimulationTest, TheFaceIsSeenAndKeptAndChangesNoPhysics) {
  auto plain = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, true);
  auto puzzled = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, true);
  EXPECT_EQ(plain->visual_state(), puzzled->visual_state());
  puzzled->Apply(Face{.face_expression = robot::FaceExpression::kPuzzled});
  EXPECT_NE(plain->visual_state(), puzzled->visual_state());
  TickSeconds(*plain, 0.2);
  TickSeconds(*puzzled, 0.2);
  EXPECT_EQ(plain->state_hash(), puzzled->state_hash());

  const SimulationState state = puzzled->Save();
  puzzled->Apply(Grasp{.object = "a"});
  puzzled->Apply(Face{.face_expression = robot::FaceExpression::kDone});
  puzzled->Apply(Undo{});
  EXPECT_EQ(puzzled->face_expression(), robot::FaceExpression::kPuzzled);
  puzzled->Apply(Redo{});
  EXPECT_EQ(puzzled->face_expression(), robot::FaceExpression::kDone);
  plain->Restore(state);
  EXPECT_EQ(plain->face_expression(), robot::FaceExpression::kPuzzled);
}

TEST_F(SimulationTest, AFaceNeedsARobot) {
  auto simulation = MakeSimulation({}, false);
  EXPECT_EQ(simulation->Apply(Face{.face_expression = robot::FaceExpression::kDone}),
            "there is no robot in this simulation");
  EXPECT_EQ(simulation->face_expression(), robot::FaceExpression::kIdle);
}

TEST_F(SimulationTest, TheRobotStandsStillWithoutCommands) {
  auto simulation = MakeSimulation({}, true);
  const std::vector<double> before = simulation->robot()->positions();
  TickSeconds(*simulation, 2);
  const std::vector<double> after = simulation->robot()->positions();
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(after[i], before[i], 1e-6) << Baxter().links[i].joint_name;
  }
}

TEST_F(SimulationTest, JointsFollowTheirVelocities) {
  auto simulation = MakeSimulation({}, true);
  const std::vector<double> before = simulation->robot()->ArmAngles(0);
  simulation->Apply(JointVelocities{.arms = {{"left", {0.2, -0.2, 0.1, -0.3, 0.2, -0.1, 0.3}}}});
  TickSeconds(*simulation, 1);
  simulation->Apply(JointVelocities{.arms = {{"left", std::vector<double>(7, 0.0)}}});
  TickSeconds(*simulation, 1);
  const std::vector<double> after = simulation->robot()->ArmAngles(0);
  const double moved[7] = {0.2, -0.2, 0.1, -0.3, 0.2, -0.1, 0.3};
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(after[i] - before[i], moved[i], 1e-3) << i;
}

/// A block on a pillar between the left fingers, as the robot stands at the start.
class GripperTest : public SimulationFixture {
 protected:
  GripperTest() {
    X_WG_ = MakeSimulation({}, true)->robot()->ToolPose(0);
    const Vector3 p_WG = X_WG_.translation();
    const double pillar_height = p_WG.z() - 0.05;
    simulation_ = MakeSimulation({BlockAt("pillar", {p_WG.x(), p_WG.y(), pillar_height / 2},
                                          /*mass=*/0, {0.06, 0.06, pillar_height}),
                                  BlockAt("block", p_WG + Vector3(0, 0, 0.001))},
                                 true);
  }
  void Grip(double rate) {
    simulation_->Apply(JointVelocities{.grippers = {{"left", rate}, {"right", 0}}});
  }

  RigidTransform X_WG_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(GripperTest, ClosingHoldsTheBlockAndOpeningReleasesIt) {
  Grip(-0.1);
  TickSeconds(*simulation_, 1.5);
  ASSERT_EQ(simulation_->robot()->HeldBodies(0).size(), 1u);
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), 0.1, 0.012);

  const Vector3 start = PositionOf(*simulation_, "block");
  simulation_->Apply(JointVelocities{.arms = {{"left", {0, -0.3, 0, 0, 0, 0, 0}}}});
  TickSeconds(*simulation_, 1);
  simulation_->Apply(JointVelocities{.arms = {{"left", std::vector<double>(7, 0.0)}}});
  const Vector3 carried = PositionOf(*simulation_, "block");
  EXPECT_GT((carried - start).norm(), 0.02);

  Grip(0.01);
  EXPECT_TRUE(simulation_->robot()->HeldBodies(0).empty());
  TickSeconds(*simulation_, 1);
  EXPECT_LT(PositionOf(*simulation_, "block").z(), carried.z() - 0.02);
}

TEST_F(GripperTest, AHeldObjectStaysInPlaceInTheGripper) {
  Grip(-0.1);
  TickSeconds(*simulation_, 1.5);
  const auto in_gripper = [this] {
    return (simulation_->robot()->ToolPose(0).inverse() * PositionOf(*simulation_, "block")).eval();
  };
  const Vector3 before = in_gripper();
  simulation_->Apply(JointVelocities{.arms = {{"left", {0.4, -0.5, 0.2, -0.3, 0.5, 0.2, 0.5}}}});
  double worst = 0;
  for (int i = 0; i < 90; ++i) {
    simulation_->Tick();
    worst = std::max(worst, (in_gripper() - before).norm());
  }
  EXPECT_LT(worst, 0.001);  // [m]
}

TEST_F(GripperTest, TheHandCannotTakeWhatTheRobotHolds) {
  Grip(-0.1);
  TickSeconds(*simulation_, 1.5);
  EXPECT_EQ(simulation_->Apply(Grasp{.object = "block"}), "'block' is held by the robot");
}

TEST_F(GripperTest, SnapshotsHoldOnToWhatItHolds) {
  Grip(-0.1);
  TickSeconds(*simulation_, 1.5);
  const SimulationState holding = simulation_->Save();
  TickSeconds(*simulation_, 0.5);
  const std::uint64_t hash = simulation_->state_hash();
  Grip(0.1);
  TickSeconds(*simulation_, 1);
  simulation_->Restore(holding);
  TickSeconds(*simulation_, 0.5);
  EXPECT_EQ(simulation_->state_hash(), hash);
}

}  // namespace
}  // namespace smile::sim
