#include "motion/path_check.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "arm.h"
#include "motion/planning_robot.h"

namespace smile::motion {
namespace {

/// Returns the robot at its default place, in units of 0.1 m; the table's near edge is at y = -6.
PlanningRobot AtTable() {
  Eigen::Matrix4d base;
  base << 0, -1, 0, 0, 1, 0, 0, -8, 0, 0, 1, 2, 0, 0, 0, 1;
  return {Baxter(), base, 0.1};
}

TEST(FirstInvalid, FindsWhenTheHandWouldTouchTheTable) {
  const PlanningRobot robot = AtTable();
  const std::vector<double> q = *robot.NamedPose("left", "untucked");
  Eigen::Matrix4d goal = robot.Forward("left", q);
  goal.block<3, 1>(0, 3) << -2, -4, 2;
  const auto above = robot.Inverse("left", goal, q, {.any_turn = true});
  ASSERT_TRUE(above);
  goal(2, 3) = -1;  // 0.1 m under the table top: the fingertips meet it 0.75 units earlier
  const auto answer = robot.MoveLine("left", *above, goal, {.tool_speed = 1, .any_turn = true});
  ASSERT_TRUE(std::holds_alternative<JointTrajectory>(answer))
      << std::get<LineFault>(answer).reason;
  const auto& down = std::get<JointTrajectory>(answer);
  EXPECT_EQ(robot.FirstInvalid(down, {}, std::nullopt), std::nullopt);

  const auto touch = robot.FirstInvalid(down, {}, std::pair(20.0, 12.0));
  ASSERT_TRUE(touch);
  EXPECT_NE(touch->reason.find("left_gripper"), std::string::npos) << touch->reason;
  EXPECT_NE(touch->reason.find("would touch an obstacle"), std::string::npos);
  const double z = robot.Forward("left", SampleAt(down, touch->seconds).positions)(2, 3);
  EXPECT_NEAR(z, 0.75, 0.15);
}

TEST(FirstInvalid, FindsWhereArmsMeetUnlessTheOtherIsElsewhere) {
  const PlanningRobot robot = AtTable();
  const std::vector<double> out(7, 0.0);
  std::vector<double> across = out;
  across[0] = -1.6;  // both arms reach over to the other side
  const JointTrajectory move = robot.MoveJoints("left", std::vector{out, across});
  std::vector<double> q_both = out;
  q_both.insert(q_both.end(), out.begin(), out.end());
  q_both[7] = 1.6;
  const auto touch = robot.FirstInvalid(move, q_both, std::nullopt);
  ASSERT_TRUE(touch);
  EXPECT_NE(touch->reason.find("right_"), std::string::npos) << touch->reason;
  EXPECT_GT(touch->seconds, 0);
  q_both[7] = -1.6;
  EXPECT_EQ(robot.FirstInvalid(move, q_both, std::nullopt), std::nullopt);
}

TEST(FirstInvalid, AnswersAsARobotThatWasAskedNothingBeforeAndToSeveralThreads) {
  const PlanningRobot robot = AtTable();
  const auto move_of = [&](const std::string& arm) {
    const std::vector<double> q = *robot.NamedPose(arm, "untucked");
    return robot.MoveJoints(arm, std::vector{q, q});
  };
  const JointTrajectory left = move_of("left"), right = move_of("right");
  const double height = robot.Forward("left", left.points[0].positions)(2, 3);
  // More rods in either hand, with and without the table, than probes are kept; the longer ones
  // reach the table.
  const auto ask = [&](const PlanningRobot& asked, int question) {
    const Vector3 upper(0.1, 0.1, 0.2 + height * (question / 4) / 4);
    return asked.FirstInvalid(
        question / 2 % 2 == 0 ? left : right, {},
        question % 2 == 0 ? std::nullopt : std::optional(std::pair(20.0, 12.0)),
        HeldBox{.lower = {-0.1, -0.1, 0}, .upper = upper});
  };
  std::vector<std::optional<InvalidMoment>> expected;
  for (int question = 0; question < 24; ++question) expected.push_back(ask(AtTable(), question));
  EXPECT_NE(expected[0], expected[21]) << "not all questions have the same answer";
  EXPECT_NE(expected[21], expected[23]) << "each hand has its own";
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      for (int i = 0; i < 48; ++i) {
        const int question = (i * (2 * thread + 1)) % 24;
        EXPECT_EQ(ask(robot, question), expected[static_cast<std::size_t>(question)]) << question;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(FirstInvalid, FindsWhereWhatAHandHoldsMeetsTheTableOrTheRobot) {
  const PlanningRobot robot = AtTable();
  const std::vector<double> q = *robot.NamedPose("left", "untucked");
  const JointTrajectory still = robot.MoveJoints("left", std::vector{q, q});
  using Table = std::optional<std::pair<double, double>>;
  const auto reason = [&](const HeldBox& held, const Table& table) {
    const auto touch = robot.FirstInvalid(still, {}, table, held);
    return touch ? touch->reason : "";
  };
  const Vector3 small(0.2, 0.2, 0.2);
  const std::pair table(20.0, 12.0);
  // A block between the fingers is no obstacle to them; a rod that reaches the table is.
  EXPECT_EQ(reason({-small, small}, table), "");
  const double height = robot.Forward("left", q)(2, 3);
  EXPECT_EQ(reason({-small, Vector3(0.2, 0.2, height + 0.2)}, table),
            "left_wrist would touch an obstacle");
  EXPECT_EQ(reason({-small, Vector3(0.2, 0.2, height + 0.2)}, std::nullopt), "");
  // A plate as wide as the robot meets its other parts.
  EXPECT_NE(reason({Vector3(-10, -10, 0), Vector3(10, 10, 0.1)}, std::nullopt), "");
  EXPECT_THROW(reason({Vector3::Zero(), Vector3(1, 0, 1)}, table), std::invalid_argument);
}

TEST(FirstInvalid, NamesTheLimitThatIsBroken) {
  const PlanningRobot robot = AtTable();
  JointTrajectory move = robot.MoveJoints(
      "left", std::vector{std::vector<double>(7, 0.0), std::vector<double>(7, 0.3)}, 0.3);
  for (TrajectoryPoint& point : move.points) {
    point.seconds /= 2;
    for (double& velocity : point.velocities) velocity *= 2;
  }
  const auto breach = robot.FirstInvalid(move, {}, std::nullopt);
  ASSERT_TRUE(breach);
  EXPECT_EQ(breach->reason, "left_s0: acceleration is 12 rad/s2, expected at most 3 rad/s2");
  EXPECT_LE(breach->seconds, move.points[1].seconds);
  move.joint_names[0] = "left_x0";
  EXPECT_THROW(robot.FirstInvalid(move, {}, std::nullopt), std::invalid_argument);
}

TEST(PlanningRobot, UsesUnitsOfTheScene) {
  const PlanningRobot robot = AtTable();
  const std::vector<double> zero(7, 0.0);
  const Eigen::Matrix4d pose = robot.Forward("left", zero);
  // The hand of the zero pose is at 0.79746 0.99246 0.32098 from the base, the tool 0.0818 beyond.
  EXPECT_NEAR(pose(0, 3), -10 * (0.99246 + 0.0818 * 0.70711), 1e-3);
  EXPECT_NEAR(pose(1, 3), -8 + 10 * (0.79746 + 0.0818 * 0.70711), 1e-3);
  EXPECT_NEAR(pose(2, 3), 2 + 3.2098, 1e-3);

  const Eigen::MatrixXd J = robot.Jacobian("left", zero);
  constexpr double kH = 1e-6;
  for (int i = 0; i < 7; ++i) {
    std::vector<double> q = zero;
    q[i] = kH;
    const Eigen::Vector3d slope = (robot.Forward("left", q) - pose).topRightCorner<3, 1>() / kH;
    EXPECT_LT((J.col(i).head<3>() - slope).norm(), 1e-4) << i;
  }
}

TEST(PlanningRobot, NamesWhatItCannotTake) {
  const PlanningRobot robot = AtTable();
  const auto message = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  const std::vector<double> zero(7, 0.0);
  EXPECT_EQ(message([&] { (void)robot.Forward("lef", zero); }),
            "arm is \"lef\", expected left or right");
  EXPECT_EQ(message([&] { (void)robot.Forward("left", std::vector<double>(6, 0.0)); }),
            "q has 6 values, expected 7");
  EXPECT_EQ(message([&] { (void)robot.Inverse("left", 2 * Eigen::Matrix4d::Identity(), zero); }),
            "goal is not a pose, expected 4x4 with a rotation, a position and a last row 0 0 0 1");
  EXPECT_EQ(message([&] { PlanningRobot(Baxter(), Eigen::Matrix4d::Identity(), 0); }),
            "unit is 0, expected metres per unit, above 0");
  EXPECT_EQ(robot.NamedPose("left", "nonsense"), std::nullopt);
}

}  // namespace
}  // namespace smile::motion
