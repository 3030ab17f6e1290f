#include "motion/inverse_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arm.h"
#include "robot/kinematics.h"
#include "robot/test/fk_vectors.h"
#include "robot/test/generated_robot.h"

namespace smile::motion {
namespace {

const std::vector<double> kUntucked{-0.08, -1, -1.19, 1.94, 0.67, 1.03, -0.5};

void ExpectWithinLimits(const ArmKinematics& arm, const std::vector<double>& q) {
  for (int i = 0; i < arm.num_joints(); ++i) {
    EXPECT_GE(q[i], arm.limits()[i].lower);
    EXPECT_LE(q[i], arm.limits()[i].upper);
  }
}

TEST(ArmKinematics, AgreesWithTheWholeRobotsKinematics) {
  std::mt19937 random(1);
  const RigidTransform X_WBase(Quaternion(0.8, 0.1, -0.3, 0.5).normalized(), Vector3(1, -2, 0.3));
  for (const robot::Arm& arm : Baxter().arms) {
    const ArmKinematics kinematics(Baxter(), arm, X_WBase);
    for (int trial = 0; trial < 100; ++trial) {
      const std::vector<double> q_arm = RandomArm(kinematics, &random);
      std::vector<double> q = Baxter().q_start;
      for (std::size_t i = 0; i < q_arm.size(); ++i) q[arm.joints[i]] = q_arm[i];

      ArmJacobian J;
      const RigidTransform X_WG = kinematics.ToolPose(q_arm, &J);
      const RigidTransform expected = robot::FramePose(Baxter(), X_WBase, q, arm.tool);
      EXPECT_LT((X_WG.translation() - expected.translation()).norm(), 1e-14);
      EXPECT_LT((X_WG.rotation() - expected.rotation()).norm(), 1e-14);
      const Eigen::MatrixXd J_Base = robot::GeometricJacobian(Baxter(), q, arm.tool, arm.joints);
      const Matrix3& R = X_WBase.rotation();
      EXPECT_LT((J.topRows<3>() - R * J_Base.topRows<3>()).norm(), 1e-13);
      EXPECT_LT((J.bottomRows<3>() - R * J_Base.bottomRows<3>()).norm(), 1e-13);
    }
  }
}

/// Robot with a lift, then an arm of two joints: one prismatic, one revolute about an oblique axis.
robot::RobotModel Crane() {
  robot::RobotModel model{.name = "crane"};
  const auto link = [&](int parent, scene::JointType type, const Vector3& axis) {
    const int i = model.num_joints();
    model.links.push_back(
        {.name = "l" + std::to_string(i),
         .joint_name = "j" + std::to_string(i),
         .parent = parent,
         .joint_type = type,
         .X_PJ = RigidTransform(Eigen::Quaterniond(0.9, 0.1, 0.2, 0.3).normalized(),
                                Vector3(0.1, 0.2, 0.3)),
         .axis = axis.normalized(),
         .lower = -1,
         .upper = 1,
         .max_velocity = 1});
  };
  link(-1, scene::JointType::kPrismatic, {0, 0, 1});
  link(0, scene::JointType::kRevolute, {1, 2, -2});
  link(1, scene::JointType::kPrismatic, {0, -1, 0});
  model.frames.push_back({"tool", 2, RigidTransform(Vector3(0.5, 0, 0.1))});
  model.arms.push_back({.name = "only", .joints = {2, 1}, .tool = 0});
  model.q_start = {0.5, 0, 0};
  return model;
}

TEST(ArmKinematics, TakesJointsOfAllKindsInAnyOrder) {
  const robot::RobotModel crane = Crane();
  const ArmKinematics arm(crane, crane.arms[0]);
  EXPECT_EQ(arm.joint_names(), (std::vector<std::string>{"j2", "j1"}));
  ArmJacobian J;
  const RigidTransform X = arm.ToolPose(std::vector{0.3, 0.7}, &J);
  const std::vector<double> q{0.5, 0.7, 0.3};
  const RigidTransform expected = robot::FramePose(crane, {}, q, 0);
  EXPECT_LT((X.translation() - expected.translation()).norm(), 1e-14);
  EXPECT_LT((X.rotation() - expected.rotation()).norm(), 1e-14);
  EXPECT_LT((J - robot::GeometricJacobian(crane, q, 0, crane.arms[0].joints)).norm(), 1e-13);

  robot::RobotModel two_arms = crane;
  two_arms.links.push_back(crane.links[0]);
  two_arms.q_start.push_back(0);
  two_arms.arms[0].joints = {1, 3};
  EXPECT_THROW(ArmKinematics(two_arms, two_arms.arms[0]), std::invalid_argument);
}

TEST(InverseKinematics, ReachesEveryPoseThatSomeConfigurationReaches) {
  for (const char* name : {"left", "right"}) {
    const ArmKinematics arm = ArmOf(name);
    std::mt19937 random(2);
    int num_found = 0;
    constexpr int kTrials = 2000;
    for (int trial = 0; trial < kTrials; ++trial) {
      const RigidTransform goal = arm.ToolPose(RandomArm(arm, &random));
      const auto q = SolveInverseKinematics(arm, goal, kUntucked);
      if (!q) continue;
      ++num_found;
      ExpectWithinLimits(arm, *q);
      const RigidTransform reached = arm.ToolPose(*q);
      EXPECT_LE((reached.translation() - goal.translation()).norm(), 1e-6);
      EXPECT_LE(AngleBetween(reached.rotation(), goal.rotation()), 1e-6 + 1e-9);
    }
    EXPECT_GT(num_found, 0.99 * kTrials) << name;
  }
}

TEST(InverseKinematics, FindsThePosesOfIndependentArithmetic) {
  constexpr double kToolBeyondHand = 0.0818;  // [m]
  for (const robot::FkVector& row : robot::ReadFkVectors()) {
    const ArmKinematics arm = ArmOf(row.arm.c_str());
    const RigidTransform goal = RigidTransform(row.q_BaseHand, row.p_BaseHand) *
                                RigidTransform(Vector3(0, 0, kToolBeyondHand));
    EXPECT_LT((arm.ToolPose(row.q).translation() - goal.translation()).norm(), 1e-9) << row.name;
    const auto q = SolveInverseKinematics(arm, goal, kUntucked);
    ASSERT_TRUE(q) << row.arm << " " << row.name;
    EXPECT_LE((arm.ToolPose(*q).translation() - goal.translation()).norm(), 1e-6);
  }
}

TEST(InverseKinematics, MayLeaveTheTurnAboutTheToolToTheArm) {
  const ArmKinematics arm = ArmOf("left");
  // Straight down, in front of the shoulder; the turn asked for is wherever w2 cannot go.
  for (double yaw = -3; yaw <= 3; yaw += 0.5) {
    const RigidTransform goal(
        Quaternion(Eigen::AngleAxisd(yaw, Vector3::UnitZ())) * Quaternion(0, 1, 0, 0),
        Vector3(0.65, 0.25, 0));
    const auto q = SolveInverseKinematics(arm, goal, kUntucked, {.any_turn = true});
    ASSERT_TRUE(q) << yaw;
    ExpectWithinLimits(arm, *q);
    const RigidTransform reached = arm.ToolPose(*q);
    EXPECT_LE((reached.translation() - goal.translation()).norm(), 1e-6);
    EXPECT_NEAR(reached.rotation()(2, 2), -1, 1e-11);
  }
}

/// Returns an arm of this many joints.
ArmKinematics GeneratedArm(int num_joints) {
  const robot::RobotModel model = robot::GeneratedRobot({{"arm", num_joints}}).Model();
  return ArmKinematics(model, model.arms[0]);
}

TEST(InverseKinematics, SolvesForPositionAloneWithAnyNumberOfJoints) {
  for (const int num_joints : {3, 4, 5, 6, 7}) {
    const ArmKinematics arm = GeneratedArm(num_joints);
    std::mt19937 random(7);
    for (int trial = 0; trial < 20; ++trial) {
      const RigidTransform reached = arm.ToolPose(RandomArm(arm, &random, 0.7));
      // The position of a pose that exists, with a rotation that is another one.
      const RigidTransform goal(Quaternion(0, 1, 0, 0), reached.translation());
      const std::vector<double> start(static_cast<std::size_t>(num_joints), 0.3);
      const auto q = SolveInverseKinematics(arm, goal, start, {.any_rotation = true});
      ASSERT_TRUE(q) << num_joints << ", " << trial;
      ExpectWithinLimits(arm, *q);
      EXPECT_LE((arm.ToolPose(*q).translation() - goal.translation()).norm(), 1e-6);
    }
  }
}

TEST(InverseKinematics, GraspsFromAboveWithFiveJoints) {
  const ArmKinematics arm = GeneratedArm(5);
  const RigidTransform goal(Quaternion(0, 1, 0, 0), Vector3(0.3, 0.2, 0.15));
  const std::vector<double> start(5, 0.5);
  const auto q = SolveInverseKinematics(arm, goal, start, {.any_turn = true});
  ASSERT_TRUE(q);
  EXPECT_NEAR(arm.ToolPose(*q).rotation()(2, 2), -1, 1e-11);
}

TEST(InverseKinematics, SaysWhichRotationIsTheTrouble) {
  const std::vector<double> start(4, 0.5);
  const ArmKinematics arm = GeneratedArm(4);
  const auto why = [&](const RigidTransform& goal, const IkOptions& options = {}) {
    EXPECT_FALSE(SolveInverseKinematics(arm, goal, start, options));
    return WhyUnreachable(arm, goal, start, options);
  };
  const Vector3 p(0.3, 0.2, 0.15);
  // Straight down, but turned out of the plane of the arm.
  EXPECT_EQ(why({Quaternion(0, 1, 0, 0), p}),
            "the tool reaches this place and direction with another turn about its axis only: an "
            "arm of 4 joints cannot take every rotation");
  // Across the plane of the arm.
  const RigidTransform across(Quaternion(std::sqrt(0.5), std::sqrt(0.5), 0, 0), p);
  EXPECT_EQ(why(across, {.any_turn = true}),
            "the tool reaches this place with another rotation only: an arm of 4 joints cannot "
            "take every rotation");
  EXPECT_EQ(why({Quaternion(0, 1, 0, 0), Vector3(3, 0, 0)}), "the tool does not reach this place");
}

TEST(InverseKinematics, StaysNearItsStart) {
  const ArmKinematics arm = ArmOf("right");
  std::mt19937 random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<double> start = RandomArm(arm, &random, 0.9);
    EXPECT_EQ(SolveInverseKinematics(arm, arm.ToolPose(start), start), start);
    std::vector<double> nearby = start;
    for (double& angle : nearby)
      angle += std::uniform_real_distribution<double>(-0.02, 0.02)(random);
    const auto q = SolveInverseKinematics(arm, arm.ToolPose(nearby), start);
    ASSERT_TRUE(q);
    for (int i = 0; i < 7; ++i) EXPECT_NEAR((*q)[i], start[i], 0.3) << trial;
  }
}

TEST(InverseKinematics, GivesTheMirroredAnswerToTheMirroredQuestion) {
  const ArmKinematics left = ArmOf("left"), right = ArmOf("right");
  const std::vector<double> sign{-1, 1, -1, 1, -1, 1, -1};
  const auto mirrored = [&](std::vector<double> q) {
    for (int i = 0; i < 7; ++i) q[i] *= sign[i];
    return q;
  };
  std::mt19937 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<double> q = RandomArm(left, &random, 0.8);
    // The first attempt only: further ones start at random.
    const IkOptions once{.max_iterations = 12};
    const auto q_left = SolveInverseKinematics(left, left.ToolPose(q), kUntucked, once);
    const auto q_right =
        SolveInverseKinematics(right, right.ToolPose(mirrored(q)), mirrored(kUntucked), once);
    ASSERT_EQ(q_left.has_value(), q_right.has_value()) << trial;
    if (!q_left) continue;
    for (int i = 0; i < 7; ++i) EXPECT_NEAR(mirrored(*q_right)[i], (*q_left)[i], 1e-6);
  }
}

TEST(InverseKinematics, FailsDeterministicallyAfterItsBudget) {
  const ArmKinematics arm = ArmOf("left");
  const RigidTransform too_far(Vector3(3, 0, 0));
  EXPECT_EQ(SolveInverseKinematics(arm, too_far, kUntucked), std::nullopt);
  EXPECT_EQ(SolveInverseKinematics(arm, RigidTransform(Vector3(1e12, 0, 0)), kUntucked),
            std::nullopt);

  std::mt19937 random(8);
  const RigidTransform goal = arm.ToolPose(RandomArm(arm, &random));
  const auto once = SolveInverseKinematics(arm, goal, kUntucked);
  ASSERT_TRUE(once);
  EXPECT_EQ(SolveInverseKinematics(arm, goal, kUntucked), once);
}

TEST(InverseKinematics, RefusesWhatIsNoQuestion) {
  const ArmKinematics arm = ArmOf("left");
  const RigidTransform goal = arm.ToolPose(kUntucked);
  EXPECT_THROW((void)SolveInverseKinematics(arm, goal, std::vector(6, 0.0)), std::invalid_argument);
  EXPECT_THROW((void)SolveInverseKinematics(arm, goal, std::vector<double>(7, NAN)),
               std::invalid_argument);
  EXPECT_THROW(
      (void)SolveInverseKinematics(arm, {Matrix3(2 * goal.rotation()), Vector3::Zero()}, kUntucked),
      std::invalid_argument);
  EXPECT_THROW((void)SolveInverseKinematics(arm, RigidTransform(Vector3(NAN, 0, 0)), kUntucked),
               std::invalid_argument);
  EXPECT_THROW((void)SolveInverseKinematics(arm, goal, kUntucked, {.max_iterations = 0}),
               std::invalid_argument);
  EXPECT_THROW((void)SolveInverseKinematics(arm, goal, kUntucked, {.position_tolerance = NAN}),
               std::invalid_argument);
}

}  // namespace
}  // namespace smile::motion
