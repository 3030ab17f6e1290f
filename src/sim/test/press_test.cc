// Contact presses switches: a finger of Baxter in the drive task, and what falls or is carried.

#include "math/angles.h"
#include "motion/inverse_kinematics.h"
#include "scene_xml/scene_reader.h"
#include "sim/event_words.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

/// Keeps the presses and the changes of controls.
struct PressLog : Listener {
  void OnEvent(const Simulation&, const Event& event) override {
    if (event.kind == EventKind::kPressed) presses.push_back(event);
    if (event.kind == EventKind::kControlChanged) changes.push_back(event);
  }
  std::vector<Event> presses, changes;
};

class PressTest : public SimulationFixture {
 protected:
  static constexpr int kArm = 1;  ///< right

  /// Returns the angles of the right arm, near `q`, at which its tool has a pose.
  static std::vector<double> AnglesAt(const Simulation& simulation, const RigidTransform& X_WG,
                                      const std::vector<double>& q, bool any_turn = false) {
    const world::RobotBody& body = *simulation.robot();
    const motion::ArmKinematics arm(body.model(), body.model().arms[kArm], body.base_pose());
    return motion::SolveInverseKinematics(arm, X_WG, q, {.any_turn = any_turn}).value();
  }
  /// Moves the right tool straight to a point at this speed.
  static void MoveTool(Simulation& simulation, const Vector3& p_WGoal, double speed) {
    const world::RobotBody& body = *simulation.robot();
    const RigidTransform X_WG = body.ToolPose(kArm);
    const Vector3 p_WG = X_WG.translation();
    const double length = (p_WGoal - p_WG).norm();
    std::vector<double> q = body.ArmAngles(kArm);
    // An angle for each tick, as velocities.
    const int count = static_cast<int>(length / speed * kTicksPerSecond) + 1;
    for (int i = 1; i <= count; ++i) {
      const RigidTransform X_WNext(X_WG.rotation(), p_WG + (p_WGoal - p_WG) * i / count);
      const std::vector<double> next = AnglesAt(simulation, X_WNext, q);
      std::vector<double> velocities;
      for (std::size_t k = 0; k < q.size(); ++k) {
        velocities.push_back((next[k] - q[k]) * kTicksPerSecond);
      }
      simulation.Apply(JointVelocities{.arms = {{"right", velocities}}});
      simulation.Tick();
      q = next;
    }
    simulation.Apply(JointVelocities{.arms = {{"right", std::vector<double>(q.size())}}});
    simulation.Tick();
  }
};

TEST_F(PressTest, ARobotPressesTheSwitchThatTheDriveTaskBeginsWith) {
  Simulation simulation(scene_xml::LoadScene(DataFile("scenes/drive_robot.xml")),
                        RobotPlacement{.model = Baxter()});
  PressLog log;
  simulation.AddListener(&log);
  simulation.Apply(MoveGripper{.arm = "both", .velocity = -0.05});
  // The raised button of RackSwitch2 is right of its hinge, which is at (1.5, -4.1, 0.35) units.
  // The tip of the closed left finger is 6 cm left of the tool point and 7.5 cm below it.
  const Vector3 p_WButton(0.172, -0.41, 0.055), p_TipTool(0.057, 0, 0.075);
  const Vector3 above = p_WButton + p_TipTool + Vector3(0, 0, 0.03);
  const Vector3 pressed = p_WButton + p_TipTool - Vector3(0, 0, 0.008);
  const RigidTransform X_WAbove(RotationFromFixedAxes({180, 0, -90}), above);
  simulation.Apply(JointAngles{
      .arms = {{"right", AnglesAt(simulation, X_WAbove, {0.6, -0.3, 0, 0.95, 0, 0.92, 0})}}});
  TickSeconds(simulation, 2);
  ASSERT_TRUE(log.presses.empty());
  MoveTool(simulation, pressed, 0.05);
  ASSERT_EQ(log.presses.size(), 1u);
  EXPECT_EQ(log.presses[0].control, "RackSwitch2");
  EXPECT_EQ(log.presses[0].arm, "right");
  EXPECT_EQ(log.presses[0].by, "");
  EXPECT_EQ(WordsOf(log.presses[0]), "RackSwitch2 pressed by right gripper");
  // The switch itself, and its light from failed to off.
  ASSERT_EQ(log.changes.size(), 2u);
  EXPECT_EQ(log.changes[1].control, "RackLight2");
  EXPECT_EQ(log.changes[1].state, "off");
  // It stays pressed while the finger stays and while it leaves.
  TickSeconds(simulation, 1);
  MoveTool(simulation, above, 0.1);
  EXPECT_EQ(log.presses.size(), 1u);
}

TEST_F(PressTest, ACarriedBlockPressesAndUndoTakesThePressBack) {
  scene::ObjectSpec panel{.whole = {.id = "power",
                                    .X_PE = RigidTransform(Vector3(0, 0, 0.05)),
                                    .shape = scene::ToggleSwitch{.size = {0.2, 0.1, 0.02}}},
                          .mass = 0};
  Simulation simulation({.name = "test", .objects = {panel, BlockAt("block", {0.05, 0, 0.3})}});
  PressLog log;
  simulation.AddListener(&log);
  ASSERT_FALSE(simulation.Apply(Grasp{.hand = HandName::kLeft, .object = "block"}));
  ASSERT_FALSE(simulation.Apply(MoveTo{.hand = HandName::kLeft, .p_WH = {0.06, 0, 0.1}}));
  const SimulationState before = simulation.Save();
  TickSeconds(simulation, 2);
  ASSERT_EQ(log.presses.size(), 1u);
  EXPECT_EQ(log.presses[0].by, "block");
  const std::uint64_t end = simulation.state_hash();

  // The same bits from a saved state, elsewhere and in the middle of the press.
  Simulation other(simulation.start_model());
  other.Restore(before);
  TickSeconds(other, 1);
  const SimulationState middle = other.Save();
  other.Restore(before);
  other.Restore(middle);
  TickSeconds(other, 1);
  EXPECT_EQ(other.state_hash(), end);

  ASSERT_FALSE(simulation.Apply(Undo{}));
  EXPECT_EQ(simulation.tabletop().controls().states()[model::ControlIndex(0)].position, 0);
  EXPECT_FALSE(simulation.tabletop().state().presses[0].is_pressed());
}

}  // namespace
}  // namespace smile::sim
