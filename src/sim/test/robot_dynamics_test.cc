// Baxter at a table: obstacles to its arms, and objects they move.

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "robot/kinematics.h"
#include "robot/test/solid_overlap.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

using model::RobotBodyOptions;

constexpr RobotBodyOptions kKinematic{.is_kinematic = true};
constexpr RobotBodyOptions kByFriction{.grasps_by_friction = true};
/// The left arm over the table, fingers down, tips 2 cm above it.
const std::vector<double> kOverTable = {-0.6, -0.30, 0, 0.95, 0, 0.92, 0};
const std::vector<double> kStill(7, 0.0);

/// Returns the greatest depth of a sample point of one solid in the other [m].
double DepthOf(const scene::Solid& a, const RigidTransform& X_WA, const scene::Solid& b,
               const RigidTransform& X_WB) {
  const RigidTransform X_AB = X_WA.inverse() * X_WB, X_BA = X_AB.inverse();
  double depth = 0;
  if (X_AB.translation().norm() > robot::BoundingRadius(a.shape) + robot::BoundingRadius(b.shape)) {
    return depth;
  }
  for (const Vector3& p_BQ : robot::SamplePoints(b.shape)) {
    depth = std::max(depth, robot::DepthInside(a.shape, X_AB * p_BQ));
  }
  for (const Vector3& p_AQ : robot::SamplePoints(a.shape)) {
    depth = std::max(depth, robot::DepthInside(b.shape, X_BA * p_AQ));
  }
  return depth;
}

class RobotDynamicsTest : public SimulationFixture {
 protected:
  static std::unique_ptr<Simulation> AtATable(std::vector<scene::ObjectSpec> objects,
                                              const RobotBodyOptions& body = {}) {
    scene::SceneSpec scene{.name = "test", .objects = std::move(objects)};
    return std::make_unique<Simulation>(std::move(scene),
                                        RobotPlacement{.model = Baxter(), .body = body});
  }
  static void MoveLeft(Simulation& simulation, const std::vector<double>& velocities) {
    simulation.Apply(JointVelocities{.arms = {{"left", velocities}}});
  }
  static void Grip(Simulation& simulation, double rate) {
    simulation.Apply(JointVelocities{.grippers = {{"left", rate}, {"right", 0}}});
  }
  /// Returns joint velocities of the left arm that move its tool with this velocity [m/s], without
  /// rotation.
  static std::vector<double> VelocitiesFor(const Simulation& simulation, const Vector3& v_WG) {
    const world::RobotBody& body = *simulation.robot();
    const robot::Arm& arm = body.model().arms[0];
    const Eigen::MatrixXd J =
        robot::GeometricJacobian(body.model(), body.positions(), arm.tool, arm.joints);
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(6);
    wanted.head<3>() = body.base_pose().rotation().transpose() * v_WG;
    const Eigen::MatrixXd damped = J * J.transpose() + 1e-4 * Eigen::MatrixXd::Identity(6, 6);
    const Eigen::VectorXd v = J.transpose() * damped.ldlt().solve(wanted);
    return {v.data(), v.data() + v.size()};
  }
  static void MoveTool(Simulation& simulation, const Vector3& v_WG, double seconds) {
    for (int i = 0; i < seconds * kTicksPerSecond; ++i) {
      MoveLeft(simulation, VelocitiesFor(simulation, v_WG));
      simulation.Tick();
    }
    MoveLeft(simulation, kStill);
  }
  static std::vector<RigidTransform> LinkPosesOf(const Simulation& simulation) {
    const world::RobotBody& body = *simulation.robot();
    return robot::LinkPoses(body.model(), body.base_pose(), body.positions());
  }
  static double DepthInTable(const Simulation& simulation) {
    const auto X_WL = LinkPosesOf(simulation);
    const scene::Solid table{
        scene::Block{{2, 1.2, 0.4}}, RigidTransform(Vector3(0, 0, -0.2)), {}, ""};
    double depth = 0;
    for (std::size_t i = 0; i < X_WL.size(); ++i) {
      for (const scene::Solid& solid : Baxter().links[i].solids) {
        depth = std::max(depth, DepthOf(table, table.X_BS, solid, X_WL[i] * solid.X_BS));
      }
    }
    return depth;
  }
  static double DepthInItself(const Simulation& simulation) {
    const robot::RobotModel& model = Baxter();
    const auto X_WL = LinkPosesOf(simulation);
    const std::set<std::pair<int, int>> allowed(model.never_collide.begin(),
                                                model.never_collide.end());
    double depth = 0;
    for (int b = 0; b < model.num_joints(); ++b) {
      for (int a = -1; a < b; ++a) {
        if (allowed.contains({a, b})) continue;
        const RigidTransform& X_WA = a < 0 ? simulation.robot()->base_pose() : X_WL[a];
        for (const scene::Solid& s : a < 0 ? model.base_solids : model.links[a].solids) {
          for (const scene::Solid& t : model.links[b].solids) {
            depth = std::max(depth, DepthOf(s, X_WA * s.X_BS, t, X_WL[b] * t.X_BS));
          }
        }
      }
    }
    return depth;
  }
  static double SpeedOf(const Simulation& simulation, std::string_view id) {
    return simulation.physics().body(simulation.tabletop().Find(id)->body).linear_velocity().norm();
  }
  /// The left gripper holds a block that stood on the table, 5 cm above it.
  static std::unique_ptr<Simulation> HoldingABlock(double mass, const RobotBodyOptions& body,
                                                   std::vector<scene::ObjectSpec> others = {},
                                                   double size = 0.1) {
    auto empty = AtATable({}, body);
    empty->Apply(JointAngles{.arms = {{"left", kOverTable}}});
    const RigidTransform X_WG = empty->robot()->ToolPose(0);
    const Vector3 across = X_WG.rotation().col(1), p_WG = X_WG.translation();
    scene::ObjectSpec block = BlockAt("held", Vector3::Zero(), mass, Vector3::Constant(size));
    const Eigen::AngleAxisd turn(std::atan2(across.y(), across.x()), Vector3::UnitZ());
    block.whole.X_PE = RigidTransform(Quaternion(turn), Vector3(p_WG.x(), p_WG.y(), size / 2));
    others.push_back(block);
    auto simulation = AtATable(std::move(others), body);
    simulation->Apply(JointAngles{.arms = {{"left", kOverTable}}});
    Grip(*simulation, -0.1);
    TickSeconds(*simulation, 2);
    MoveTool(*simulation, {0, 0, 0.05}, 1);
    return simulation;
  }
};

TEST_F(RobotDynamicsTest, AtRestItStaysWhereItIsForAMinute) {
  auto simulation = AtATable({BlockAt("a", {0.5, 0.3, 0.05})});
  ASSERT_EQ(simulation->Apply(Grasp{.object = "a"}), std::nullopt) << "keeps the world awake";
  const std::vector<double> before = simulation->robot()->positions();
  TickSeconds(*simulation, 60);
  const std::vector<double> after = simulation->robot()->positions();
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-9) << i;
}

/// Commands of full speed, changed twice a second: arms ram the table, each other and the body.
TEST_F(RobotDynamicsTest, StaysWithinLimitsAndOutOfContactUnderAnyCommand) {
  constexpr double kDeepest = 0.02;  // [m]; measured: 17 mm, of the fingers; links 8 mm
  for (const unsigned seed : {2u, 5u, 6u}) {
    auto simulation = AtATable({BlockAt("a", {-0.2, -0.3, 0.05}), BlockAt("b", {0.2, -0.3, 0.05}),
                                BlockAt("c", {0, -0.2, 0.05})});
    std::mt19937 random(seed);
    const auto uniform = [&random](double a) { return a * (random() / 2147483648.0 - 1); };
    std::vector<double> q_before = simulation->robot()->positions();
    double deepest = 0;
    for (int tick = 0; tick < 300; ++tick) {
      if (tick % 30 == 0) {
        JointVelocities wanted{.arms = {{"left", kStill}, {"right", kStill}}};
        for (int i = 0; i < 7; ++i) wanted.arms["left"][i] = uniform(i < 4 ? 1.5 : 4);
        for (int i = 0; i < 7; ++i) wanted.arms["right"][i] = uniform(i < 4 ? 1.5 : 4);
        wanted.grippers["left"] = uniform(0.2);
        wanted.grippers["right"] = uniform(0.2);
        wanted.head = uniform(1.5);
        ASSERT_EQ(simulation->Apply(wanted), std::nullopt);
      }
      simulation->Tick();
      const std::vector<double> q = simulation->robot()->positions();
      ASSERT_TRUE(robot::IsWithinLimits(Baxter(), q, 1e-12)) << seed << ", tick " << tick;
      for (std::size_t i = 0; i < q.size(); ++i) {
        ASSERT_LE(std::abs(q[i] - q_before[i]),
                  Baxter().links[i].max_velocity / kTicksPerSecond + 1e-12);
      }
      q_before = q;
      if (tick % 3 == 0) {
        deepest = std::max({deepest, DepthInTable(*simulation), DepthInItself(*simulation)});
      }
      for (const char* id : {"a", "b", "c"}) ASSERT_LT(SpeedOf(*simulation, id), 8) << id;
    }
    EXPECT_LT(deepest, kDeepest) << seed;
  }
}

TEST_F(RobotDynamicsTest, PressingOnTheTableItStaysAboveAndLeavesAtOnce) {
  auto simulation = AtATable({BlockAt("a", {0.3, 0.2, 0.05}), BlockAt("b", {0.3, 0.2, 0.15})});
  simulation->Apply(JointAngles{.arms = {{"left", kOverTable}}});
  MoveLeft(*simulation, {0, 0.5, 0, 0, 0, 0, 0});
  TickSeconds(*simulation, 5);
  const std::vector<double> pressing = simulation->robot()->ArmAngles(0);
  double deepest = 0, wobble = 0;
  for (int i = 0; i < 5 * kTicksPerSecond; ++i) {
    simulation->Tick();
    deepest = std::max(deepest, DepthInTable(*simulation));
    const std::vector<double> angles = simulation->robot()->ArmAngles(0);
    for (int j = 0; j < 7; ++j) wobble = std::max(wobble, std::abs(angles[j] - pressing[j]));
  }
  EXPECT_LT(deepest, 0.001);  // [m]
  EXPECT_LT(wobble, 0.001);   // [rad]
  EXPECT_NEAR(PositionOf(*simulation, "b").z(), 0.15, 1e-4);
  const double z = simulation->robot()->ToolPose(0).translation().z();
  EXPECT_LT(z, 0.1) << "or it did not press";
  MoveLeft(*simulation, {0, -0.5, 0, 0, 0, 0, 0});
  TickSeconds(*simulation, 0.1);
  EXPECT_GT(simulation->robot()->ToolPose(0).translation().z(), z + 0.01);
}

/// The forearm points down and forward, its lower end a hand above the table; it turns about s0.
TEST_F(RobotDynamicsTest, TheForearmSweepsBlocksAsideAndIsNotThrown) {
  const std::vector<double> low = {-0.35, 0.9, 0, 0.1, 0, -1.5, 0};
  for (const RobotBodyOptions& body : {RobotBodyOptions(), kKinematic}) {
    auto simulation = AtATable({BlockAt("tall", {-0.10, -0.36, 0.1}, 1, {0.1, 0.1, 0.2}),
                                BlockAt("a", {0, -0.42, 0.05}), BlockAt("far", {0.6, 0.3, 0.05})},
                               body);
    simulation->Apply(
        JointAngles{.arms = {{"left", low}, {"right", {0.9, -1, 1.19, 1.94, -0.67, 1.03, 0.5}}}});
    TickSeconds(*simulation, 0.5);
    const std::vector<double> before = simulation->robot()->ArmAngles(0);
    MoveLeft(*simulation, {-0.5, 0, 0, 0, 0, 0, 0});
    double fastest = 0;
    for (int i = 0; i < 108; ++i) {
      simulation->Tick();
      for (const char* id : {"tall", "a", "far"})
        fastest = std::max(fastest, SpeedOf(*simulation, id));
    }
    EXPECT_GT(PositionOf(*simulation, "tall").x(), 0);
    EXPECT_GT(PositionOf(*simulation, "a").x(), 0.05) << "which the other block pushes";
    EXPECT_LT((PositionOf(*simulation, "far") - Vector3(0.6, 0.3, 0.05)).norm(), 1e-3);
    EXPECT_LT(fastest, 0.6);  // [m/s]; the forearm does 0.3
    const std::vector<double> after = simulation->robot()->ArmAngles(0);
    EXPECT_NEAR(after[0], before[0] - 0.9, 0.03);
    for (int j = 1; j < 7; ++j) EXPECT_NEAR(after[j], before[j], 0.02) << j;
  }
}

TEST_F(RobotDynamicsTest, AKinematicArmMovesExactlyAsCommandedThroughTheTable) {
  auto simulation = AtATable({}, kKinematic);
  simulation->Apply(JointAngles{.arms = {{"left", kOverTable}}});
  MoveLeft(*simulation, {0, 0.1, 9, 0, 0, 0, 0});
  TickSeconds(*simulation, 1);
  const std::vector<double> angles = simulation->robot()->ArmAngles(0);
  EXPECT_NEAR(angles[1], kOverTable[1] + 0.1, 1e-12);
  EXPECT_NEAR(angles[2], 1.5, 1e-12) << "the velocity limit holds";
  MoveLeft(*simulation, {0, 0.2, -1.5, 0, 0, 0, 0});
  TickSeconds(*simulation, 1);
  EXPECT_NEAR(simulation->robot()->ArmAngles(0)[1], kOverTable[1] + 0.3, 1e-12);
  EXPECT_GT(DepthInTable(*simulation), 0.03);
}

TEST_F(RobotDynamicsTest, AUnitCubeIsHeldWhereTheOriginalHeldIt) {
  constexpr double kOriginal = 0.10167;  // [m], as its frames of 1/60 s happened to fall
  for (const RobotBodyOptions& body : {RobotBodyOptions(), kKinematic}) {
    auto simulation = HoldingABlock(1, body);
    ASSERT_EQ(simulation->robot()->HeldBodies(0).size(), 1u);
    EXPECT_NEAR(simulation->robot()->GripperOpening(0), kOriginal, 0.0025);
  }
}

TEST_F(RobotDynamicsTest, AHeldObjectPushesOthersAndIsStoppedByTheTable) {
  const auto other = BlockAt("other", {-0.30, -0.05, 0.05});
  auto simulation = HoldingABlock(1, {}, {other});
  const Vector3 p_WHeld = PositionOf(*simulation, "held");
  MoveTool(*simulation, {0, 0, -0.1}, 1.5);
  EXPECT_NEAR(PositionOf(*simulation, "held").z(), 0.05, 0.01) << "the table stopped it";
  MoveTool(*simulation, {0, 0, 0.02}, 0.5);
  const Vector3 p_WOther = PositionOf(*simulation, "other");
  const Vector3 way = Vector3(p_WOther.x() - p_WHeld.x(), p_WOther.y() - p_WHeld.y(), 0);
  MoveTool(*simulation, 0.1 * way.normalized(), 1.5);
  EXPECT_GT((PositionOf(*simulation, "other") - p_WOther).norm(), 0.03);
}

TEST_F(RobotDynamicsTest, ItTakesTwoBlocksAtOnceAndAnyOpeningReleasesBoth) {
  auto empty = AtATable({});
  empty->Apply(JointAngles{.arms = {{"left", kOverTable}}});
  const Vector3 p = empty->robot()->ToolPose(0).translation();
  const Vector3 size(0.1, 0.1, 0.04);
  auto simulation = AtATable({BlockAt("low", {p.x(), p.y(), 0.02}, 1, size),
                              BlockAt("high", {p.x(), p.y(), 0.06}, 1, size)});
  simulation->Apply(JointAngles{.arms = {{"left", kOverTable}}});
  Grip(*simulation, -0.1);
  TickSeconds(*simulation, 2);
  EXPECT_EQ(simulation->robot()->HeldBodies(0).size(), 2u);
  MoveTool(*simulation, {0, 0, 0.1}, 1);
  EXPECT_GT(PositionOf(*simulation, "low").z(), 0.1);
  Grip(*simulation, 1e-3);
  EXPECT_TRUE(simulation->robot()->HeldBodies(0).empty());
}

TEST_F(RobotDynamicsTest, LoadsUpToThePayloadAreLiftedAndHeavierOnesAreNot) {
  auto light = HoldingABlock(1.6, {});
  EXPECT_NEAR(PositionOf(*light, "held").z(), 0.1, 0.003);
  TickSeconds(*light, 1);
  const std::vector<double> before = light->robot()->ArmAngles(0);
  TickSeconds(*light, 5);
  const std::vector<double> after = light->robot()->ArmAngles(0);
  for (int j = 0; j < 7; ++j) EXPECT_NEAR(after[j], before[j], 1e-4) << j;

  auto heavy = HoldingABlock(50, {}, {BlockAt("far", {0.5, 0.3, 0.05})});
  ASSERT_EQ(heavy->robot()->HeldBodies(0).size(), 1u);
  MoveTool(*heavy, {0, 0, 0.1}, 2);
  EXPECT_LT(PositionOf(*heavy, "held").z(), 0.06);
  EXPECT_LT((PositionOf(*heavy, "far") - Vector3(0.5, 0.3, 0.05)).norm(), 1e-4);
  Grip(*heavy, 0.1);
  TickSeconds(*heavy, 0.5);
  MoveTool(*heavy, {0, 0, 0.1}, 1);
  EXPECT_GT(heavy->robot()->ToolPose(0).translation().z(), 0.12) << "it can move again";
}

TEST_F(RobotDynamicsTest, FrictionHoldsAUnitBlockThatIsMovedAboutAndReleasesIt) {
  auto simulation = HoldingABlock(1, kByFriction);
  EXPECT_TRUE(simulation->robot()->HeldBodies(0).empty());
  const auto in_gripper = [&simulation] {
    return (simulation->robot()->ToolPose(0).inverse() * PositionOf(*simulation, "held")).eval();
  };
  const Vector3 before = in_gripper();
  for (int i = 0; i < 10 * kTicksPerSecond; ++i) {
    const double t = SecondsOf(i);
    MoveLeft(*simulation, {0.3 * std::sin(1.3 * t), -0.1 * std::cos(2 * t), 0.2 * std::sin(t), 0,
                           0.3 * std::sin(2.1 * t), -0.3 * std::sin(1.1 * t), 0.6 * std::sin(t)});
    simulation->Tick();
  }
  EXPECT_LT((in_gripper() - before).norm(), 0.005);  // [m]
  MoveLeft(*simulation, kStill);
  const double z = PositionOf(*simulation, "held").z();
  EXPECT_GT(z, 0.07);
  Grip(*simulation, 0.1);
  TickSeconds(*simulation, 1);
  EXPECT_LT(PositionOf(*simulation, "held").z(), z - 0.02);
}

TEST_F(RobotDynamicsTest, ARestoredSimulationContinuesExactlyWithEachKindOfBody) {
  for (const RobotBodyOptions& body : {RobotBodyOptions(), kKinematic, kByFriction}) {
    const auto run_on = [](Simulation& simulation) {
      MoveTool(simulation, {0.05, 0, 0.03}, 0.5);
      Grip(simulation, 0.1);
      TickSeconds(simulation, 0.5);
      return simulation.state_hash();
    };
    const auto others = {BlockAt("other", {-0.30, -0.05, 0.05})};
    auto simulation = HoldingABlock(2, body, others);
    const SimulationState holding = simulation->Save();
    const std::uint64_t hash = run_on(*simulation);
    simulation->Restore(holding);
    EXPECT_EQ(run_on(*simulation), hash);
    auto elsewhere = HoldingABlock(2, body, others);
    TickSeconds(*elsewhere, 0.3);
    elsewhere->Restore(holding);
    EXPECT_EQ(run_on(*elsewhere), hash);
  }
}

TEST_F(RobotDynamicsTest, AKinematicRobotCanNotGraspByFriction) {
  EXPECT_THROW(AtATable({}, {.is_kinematic = true, .grasps_by_friction = true}),
               std::invalid_argument);
}

}  // namespace
}  // namespace smile::sim
