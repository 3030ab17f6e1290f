#include <Eigen/LU>

#include "robot/kinematics.h"
#include "sim/test/simulation_fixture.h"

namespace smile::sim {
namespace {

/// Baxter with an electric gripper above a block of 0.1 m on a pillar.
class ElectricGripper : public SimulationFixture {
 protected:
  void StandAbove(const std::string& gripper) {
    placement_.model = robot::ReadRobot(DataFile("robots/baxter.urdf"), {.gripper = gripper});
    const RigidTransform X_WG = Simulation({}, placement_).robot()->ToolPose(0);
    // The tool is between the tips; they begin 10 mm above the block.
    const Vector3 p_WB = X_WG.translation() - Vector3(0, 0, 0.06);
    const double height = p_WB.z() - 0.051;
    scene::SceneSpec scene{.name = "test",
                           .objects = {BlockAt("pillar", {p_WB.x(), p_WB.y(), height / 2},
                                               /*mass=*/0, {0.06, 0.06, height}),
                                       BlockAt("block", p_WB)}};
    simulation_ = std::make_unique<Simulation>(std::move(scene), placement_);
  }

  /// Moves the left tool straight up or down [m/s].
  void Move(double rate, double seconds) {
    const world::RobotBody& robot = *simulation_->robot();
    const robot::Arm& arm = robot.model().arms[0];
    const Eigen::MatrixXd J =
        robot::GeometricJacobian(robot.model(), robot.positions(), arm.tool, arm.joints);
    Eigen::VectorXd v = Eigen::VectorXd::Zero(6);
    v[2] = rate;
    const Eigen::VectorXd qdot = J.transpose() * (J * J.transpose()).inverse() * v;
    simulation_->Apply(
        JointVelocities{.arms = {{"left", std::vector<double>(qdot.begin(), qdot.end())}}});
    TickSeconds(*simulation_, seconds);
    simulation_->Apply(JointVelocities{.arms = {{"left", std::vector<double>(7, 0.0)}}});
  }

  /// Reaches down over the block and closes.
  std::size_t NumHeldAfterClosing() {
    Move(-0.05, 0.9);
    simulation_->Apply(JointVelocities{.grippers = {{"left", -0.1}, {"right", 0}}});
    TickSeconds(*simulation_, 1);
    return simulation_->robot()->HeldBodies(0).size();
  }

  RobotPlacement placement_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(ElectricGripper, WithWideFingersInSlotTwoLiftsABlock) {
  StandAbove("electric-wide-2");
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), 0.1325, 0.0005);
  ASSERT_EQ(NumHeldAfterClosing(), 1u);
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), 0.1, 0.012);
  const double before = PositionOf(*simulation_, "block").z();
  Move(0.05, 1);
  EXPECT_NEAR(PositionOf(*simulation_, "block").z() - before, 0.05, 0.01);
}

TEST_F(ElectricGripper, FollowsTheOpeningThatItReports) {
  StandAbove("electric-wide-2");  // whose fingers are 0.091 m apart where they are closed
  const double open = simulation_->robot()->GripperOpening(0), wanted = open - 0.02;
  const motion::JointTrajectory close{{"left_gripper"}, {{0, {open}, {0}}, {1, {wanted}, {0}}}};
  ASSERT_EQ(simulation_->Apply(FollowTrajectory{close}), std::nullopt);
  TickSeconds(*simulation_, 1.1);
  EXPECT_FALSE(simulation_->is_robot_following()) << "there was no way to where it begins";
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), wanted, 1e-3);
  EXPECT_NE(simulation_->Apply(FollowTrajectory{{{"left_gripper"}, {{0, {0.05}, {0}}}}}),
            std::nullopt);
}

TEST_F(ElectricGripper, WithNarrowFingersCannotReachAroundIt) {
  StandAbove("electric-narrow-2");
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), 0.057, 0.0005);
  EXPECT_EQ(NumHeldAfterClosing(), 0u);
}

}  // namespace
}  // namespace smile::sim
