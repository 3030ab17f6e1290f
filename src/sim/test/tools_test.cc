// Tools in hands and grippers: recorded as events, described, undone.

#include "math/angles.h"
#include "sim/event_words.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

struct UseLog : Listener {
  void OnEvent(const Simulation&, const Event& event) override {
    if (event.kind == EventKind::kUsed) uses.push_back(event);
    if (event.kind == EventKind::kFastened) fastened.push_back(event);
    if (event.kind == EventKind::kCommandRefused) refusals.push_back(event.reason);
  }
  std::vector<Event> uses, fastened;
  std::vector<std::string> refusals;
};

class ToolsSimulationTest : public SimulationFixture {
 protected:
  /// A string of four links along x, through a point in the middle.
  static void AddString(const Vector3& p_WMiddle, scene::SceneSpec* scene) {
    scene::ChainSpec chain{.id = "Rope",
                           .start_id = "Rope-start",
                           .end_id = "Rope-end",
                           .p_WStart = p_WMiddle - Vector3(0.2, 0, 0),
                           .p_WEnd = p_WMiddle + Vector3(0.2, 0, 0),
                           .link_mass = 0.02,
                           .first_object = scene->objects.size()};
    for (int i = 0; i < 4; ++i) chain.link_ids.push_back("Rope-link" + std::to_string(i));
    for (scene::ObjectSpec& piece : PiecesOf(chain, scene->meters_per_unit)) {
      scene->objects.push_back(std::move(piece));
    }
    scene->chains.push_back(chain);
  }
};

TEST_F(ToolsSimulationTest, AHandCutsAStringAndUndoMendsIt) {
  scene::SceneSpec scene{.name = "test", .objects = {BlockAt("Scissors", {0, -0.2, 0.5}, 0.2)}};
  scene.objects[0].tool = scene::ToolSpec{.action = scene::ToolAction::kCut,
                                          .p_BT = {0, 0.06, 0},
                                          .axis = {0, 1, 0},
                                          .edge = 0.1,
                                          .reach = 0.05};
  AddString({0, 0, 0.5}, &scene);
  Simulation simulation(scene);
  UseLog log;
  simulation.AddListener(&log);
  EXPECT_EQ(simulation.Apply(Use{.hand = HandName::kLeft}).value_or(""),
            "the left hand holds nothing");
  ASSERT_FALSE(simulation.Apply(Grasp{.hand = HandName::kLeft, .object = "Scissors"}));
  ASSERT_FALSE(simulation.Apply(MoveTo{.hand = HandName::kLeft, .p_WH = {0, -0.12, 0.5}}));
  TickSeconds(simulation, 0.5);
  const std::uint64_t before = simulation.state_hash();
  ASSERT_EQ(simulation.Apply(Use{.hand = HandName::kLeft}).value_or(""), "");
  ASSERT_EQ(log.uses.size(), 1u);
  EXPECT_EQ(log.uses[0].by, "Scissors");
  EXPECT_EQ(log.uses[0].state, "cut");
  EXPECT_EQ(WordsOf(*simulation.history().current().summary),
            "left hand cuts Rope between link 1 and 2 with Scissors");
  TickSeconds(simulation, 0.5);
  EXPECT_LT(PositionOf(simulation, "Rope-link1").z(), 0.45);
  ASSERT_FALSE(simulation.Apply(Undo{}));
  EXPECT_EQ(simulation.state_hash(), before);
}

/// A screw in a nut on the table, whose head takes a screwdriver from above.
std::vector<scene::ObjectSpec> ScrewInNut(const Vector3& p_WHead) {
  scene::Composite nut, screw;
  nut.parts = {{.shape = scene::Ring{0.06, 0.03, 0.05, 12}}};
  nut.hosts = {{.id = "hole", .type = "m8", .stages = {{}, {}, {}}}};
  for (int i = 0; i < 3; ++i) {
    nut.hosts[0].stages[i].X_HS = RigidTransform(Vector3(0, 0, -0.002 * i));
  }
  screw.parts = {{.shape = scene::Block{{0.03, 0.03, 0.05}}}};
  screw.guests = {{.id = "tip",
                   .type = "m8",
                   .initial_host = "hole",
                   .initial_tightness = 1,
                   .refuses_hands = true,
                   .accepts = {{.type = "phillips", .p_GS = {0, 0, 0.025}}}}};
  const Vector3 p_WNut = p_WHead - Vector3(0, 0, 0.025);
  return {{.whole = {.id = "nut", .X_PE = RigidTransform(p_WNut), .shape = nut}, .mass = 0},
          {.whole = {.id = "screw", .X_PE = RigidTransform(p_WNut), .shape = screw}}};
}

TEST_F(ToolsSimulationTest, ARobotClosesTheScissorsWithItsGripperAndTurnsADriverWithItsWrist) {
  const std::vector<double> over_table = {-0.6, -0.30, 0, 0.95, 0, 0.92, 0};
  auto empty = MakeSimulation({}, /*with_robot=*/true);
  empty->Apply(JointAngles{.arms = {{"left", over_table}}});
  const RigidTransform X_WG = empty->robot()->ToolPose(0);
  for (const bool cuts : {true, false}) {
    // What the left gripper is about to take stands between its fingers; a long reach spares the
    // way to the work.
    scene::ObjectSpec tool = BlockAt("Tool", Vector3::Zero(), 0.1);
    const Vector3 across = X_WG.rotation().col(1), p_WG = X_WG.translation();
    const Eigen::AngleAxisd turn(std::atan2(across.y(), across.x()), Vector3::UnitZ());
    tool.whole.X_PE = RigidTransform(Quaternion(turn), Vector3(p_WG.x(), p_WG.y(), 0.05));
    tool.tool =
        scene::ToolSpec{.action = cuts ? scene::ToolAction::kCut : scene::ToolAction::kDrive,
                        .type = cuts ? "" : "phillips",
                        .edge = cuts ? 0.05 : 0,
                        .turn = DegreesToRadians(90.0),
                        .reach = 1};
    scene::SceneSpec scene{.name = "test", .objects = {tool}};
    const Vector3 p_WWork = p_WG + Vector3(-0.3, 0, 0.15);
    if (cuts) {
      AddString(p_WWork, &scene);
    } else {
      for (scene::ObjectSpec& object : ScrewInNut(p_WWork)) scene.objects.push_back(object);
    }
    Simulation simulation(scene, RobotPlacement{.model = Baxter()});
    UseLog log;
    simulation.AddListener(&log);
    simulation.Apply(JointAngles{.arms = {{"left", over_table}}});
    const auto grip = [&](double velocity) {
      simulation.Apply(MoveGripper{.arm = "left", .velocity = velocity});
      TickSeconds(simulation, 2);
    };
    grip(-0.1);
    ASSERT_EQ(simulation.robot()->HeldBodies(0).size(), 1u) << cuts;
    EXPECT_TRUE(log.uses.empty()) << "the grasp is no use";
    grip(0);
    if (cuts) {
      grip(-0.1);
      ASSERT_EQ(log.uses.size(), 1u);
      EXPECT_EQ(log.uses[0].state, "cut");
    } else {
      simulation.Apply(TurnJoint{.joint = "left_w2", .velocity = 1});
      TickSeconds(simulation, 1.7);
      ASSERT_EQ(log.uses.size(), 1u);
      // About the axis that points down: clockwise, as seen from above, tightens.
      EXPECT_EQ(log.uses[0].state, "fasten");
      ASSERT_EQ(log.fastened.size(), 1u);
      EXPECT_EQ(log.fastened[0].tightness, 2);
    }
    EXPECT_EQ(log.uses[0].arm, "left");
    EXPECT_FALSE(log.uses[0].hand.has_value());
    if (cuts) {
      EXPECT_EQ(WordsOf(log.uses[0]), "left gripper cuts " + log.uses[0].part + " with Tool");
    } else {
      EXPECT_EQ(WordsOf(log.uses[0]), "left gripper fastens screw with Tool");
    }
  }
}

}  // namespace
}  // namespace smile::sim
