#include "motion/arm_moves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "arm.h"
#include "motion/limit_check.h"
#include "robot/test/generated_robot.h"

namespace smile::motion {
namespace {

const std::vector<double> kReady{-0.08, -1, -1.19, 1.94, 0.67, 1.03, -0.5};

double DistanceFromLine(const Vector3& p, const Vector3& from, const Vector3& to) {
  const Vector3 along = to - from;
  const double share = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - from - share * along).norm();
}

/// Checks by finite differences instead of the cubics' own formulas.
void ExpectLimitsAreKept(const JointTrajectory& move, const std::vector<JointLimits>& limits) {
  EXPECT_TRUE(CheckLimits(move, limits).empty());
  constexpr int kSteps = 2000;
  const double h = move.seconds() / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const TrajectoryPoint now = SampleAt(move, k * h), next = SampleAt(move, (k + 1) * h);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const double velocity = (next.positions[i] - now.positions[i]) / h;
      const double acceleration = (next.velocities[i] - now.velocities[i]) / h;
      ASSERT_LE(std::abs(velocity), limits[i].max_velocity * (1 + 1e-6));
      ASSERT_LE(std::abs(acceleration), limits[i].max_acceleration * (1 + 1e-6));
      ASSERT_GE(now.positions[i], limits[i].lower - 1e-9);
      ASSERT_LE(now.positions[i], limits[i].upper + 1e-9);
    }
  }
}

TEST(MoveThrough, MeetsItsWaypointsWithinLimitsAndWithoutStopping) {
  const ArmKinematics arm = ArmOf("left");
  std::mt19937 random(3);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<std::vector<double>> waypoints;
    for (int k = 0; k < 2 + trial % 5; ++k) waypoints.push_back(RandomArm(arm, &random));
    waypoints.back()[1] = arm.limits()[1].upper;
    waypoints[waypoints.size() / 2][2] = arm.limits()[2].lower;
    const double speed = trial % 2 ? 1 : 0.3;
    const JointTrajectory move{arm.joint_names(), MoveThrough(waypoints, arm.limits(), speed)};
    ExpectLimitsAreKept(move, arm.limits());
    EXPECT_EQ(SampleAt(move, 0).positions, waypoints.front());
    EXPECT_EQ(SampleAt(move, move.seconds()).positions, waypoints.back());
    if (waypoints.size() < 3) continue;
    // One after another; even where all joints turn back all the time, about as soon as with stops.
    auto point = move.points.begin();
    double with_stops = 0;
    for (std::size_t k = 0; k < waypoints.size(); ++k) {
      point = std::find_if(point, move.points.end(), [&](const TrajectoryPoint& each) {
        return each.positions == waypoints[k];
      });
      ASSERT_NE(point, move.points.end()) << k;
      if (k == 0) continue;
      with_stops +=
          MoveStraight(waypoints[k - 1], waypoints[k], arm.limits(), speed).back().seconds;
    }
    EXPECT_LT(move.seconds(), 1.1 * with_stops);
    for (const TrajectoryPoint& end : {move.points.front(), move.points.back()}) {
      EXPECT_EQ(end.velocities, std::vector<double>(7, 0.0));
    }
  }
  // A joint that keeps its direction does not stop on the way.
  std::vector<std::vector<double>> onwards(31, std::vector<double>(7, 0));
  for (int k = 0; k <= 30; ++k) onwards[k][0] = 0.05 * k;
  const double at_once = MoveStraight(onwards.front(), onwards.back(), arm.limits()).back().seconds;
  EXPECT_LT(MoveThrough(onwards, arm.limits()).back().seconds, 1.1 * at_once);
}

TEST(MoveThrough, CountsEqualWaypointsOnceAndNamesBadOnes) {
  const ArmKinematics arm = ArmOf("left");
  const std::vector<std::vector<double>> same(3, kReady);
  EXPECT_EQ(MoveThrough(same, arm.limits()).size(), 1u);
  std::vector<std::vector<double>> beyond(2, kReady);
  beyond[1][3] = 3;
  try {
    MoveThrough(beyond, arm.limits());
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "waypoint 1: joint 3 would be at 3, expected -0.05 to 2.618");
  }
  EXPECT_THROW(MoveThrough({}, arm.limits()), std::invalid_argument);
  EXPECT_THROW(MoveThrough(same, arm.limits(), 1.5), std::invalid_argument);
}

TEST(MoveAlongLine, KeepsToTheLineAndToAllLimits) {
  int num_found = 0, num_refused = 0;
  for (const char* name : {"left", "right"}) {
    const ArmKinematics arm = ArmOf(name);
    std::mt19937 random(11);
    for (int trial = 0; trial < 60; ++trial) {
      const std::vector<double> from = RandomArm(arm, &random, 0.7);
      std::vector<double> to = from;
      for (double& angle : to) angle += std::uniform_real_distribution<double>(-0.4, 0.4)(random);
      const RigidTransform X_WG_from = arm.ToolPose(from), X_WG_to = arm.ToolPose(to);
      const LineOptions options{.speed = trial % 3 ? 1 : 0.4, .any_turn = trial % 2 == 0};
      const auto answer = MoveAlongLine(arm, from, X_WG_to, options);
      if (const auto* fault = std::get_if<LineFault>(&answer)) {
        EXPECT_GE(fault->fraction, 0);
        EXPECT_LT(fault->fraction, 1);
        EXPECT_FALSE(fault->reason.empty());
        ++num_refused;
        continue;
      }
      ++num_found;
      const auto& move = std::get<JointTrajectory>(answer);
      ExpectLimitsAreKept(move, arm.limits());
      EXPECT_EQ(move.points.front().positions, from);
      const RigidTransform reached = arm.ToolPose(move.points.back().positions);
      EXPECT_LT((reached.translation() - X_WG_to.translation()).norm(), 1e-8);
      if (options.any_turn) {
        EXPECT_LT((reached.rotation().col(2) - X_WG_to.rotation().col(2)).norm(), 1e-8);
      } else {
        EXPECT_LT(AngleBetween(reached.rotation(), X_WG_to.rotation()), 1e-7);
      }
      for (int k = 0; k <= 1000; ++k) {
        const RigidTransform X_WG =
            arm.ToolPose(SampleAt(move, move.seconds() * k / 1000).positions);
        ASSERT_LT(
            DistanceFromLine(X_WG.translation(), X_WG_from.translation(), X_WG_to.translation()),
            0.001);
      }
      EXPECT_EQ(std::get<JointTrajectory>(MoveAlongLine(arm, from, X_WG_to, options)), move);
    }
  }
  EXPECT_GT(num_found, 2 * num_refused);
}

TEST(MoveAlongLine, MayLeaveTheRotationToAnArmOfFewJoints) {
  const robot::RobotModel model = robot::GeneratedRobot({{"arm", 5}}).Model();
  const ArmKinematics arm(model, model.arms[0]);
  const std::vector<double> from{0.2, 0.8, 0.8, 0.9, 0};
  const RigidTransform X_WG = arm.ToolPose(from);
  // Past the arm's axis, so that its plane turns; the rotation of the tool would stay.
  const RigidTransform goal(X_WG.rotation(), X_WG.translation() + Vector3(-0.05, 0.15, -0.05));
  const auto refused = MoveAlongLine(arm, from, goal);
  ASSERT_TRUE(std::holds_alternative<LineFault>(refused));
  EXPECT_TRUE(std::get<LineFault>(refused).reason.ends_with(
      "; it can with any rotation of the tool, since an arm of 5 joints cannot keep every "
      "rotation"))
      << std::get<LineFault>(refused).reason;
  const auto answer = MoveAlongLine(arm, from, goal, {.any_rotation = true});
  ASSERT_TRUE(std::holds_alternative<JointTrajectory>(answer));
  const auto& move = std::get<JointTrajectory>(answer);
  ExpectLimitsAreKept(move, arm.limits());
  for (int k = 0; k <= 100; ++k) {
    const RigidTransform X_WGk = arm.ToolPose(SampleAt(move, move.seconds() * k / 100).positions);
    ASSERT_LT(DistanceFromLine(X_WGk.translation(), X_WG.translation(), goal.translation()), 0.001);
  }
}

TEST(MoveAlongLine, AllowsForRoundedNumbersInTheDescriptionOfAnArmOfFewJoints) {
  robot::RobotModel model = robot::GeneratedRobot({{"arm", 5}}).Model();
  const std::vector<double> from{0.2, 0.8, 0.8, 0.9, 0};
  // The second joint is out of line with the third by as much as rounded angles are. The tool then
  // leans as the arm stretches.
  const auto line = [&](double error) {
    RigidTransform& X_PJ = model.links[model.arms[0].joints[2]].X_PJ;
    X_PJ = X_PJ *
           RigidTransform(Quaternion(Eigen::AngleAxisd(error, Vector3::UnitX())), Vector3::Zero());
    const ArmKinematics arm(model, model.arms[0]);
    const RigidTransform X_WG = arm.ToolPose(from);
    const Vector3 p_WG_goal = X_WG.translation() + Vector3(0, 0, -0.1);
    return MoveAlongLine(arm, from, {X_WG.rotation(), p_WG_goal});
  };
  EXPECT_TRUE(std::holds_alternative<JointTrajectory>(line(1e-5)));
  EXPECT_TRUE(std::holds_alternative<LineFault>(line(0.05)));
}

TEST(MoveAlongLine, KeepsTheToolsSpeedAndTurnsEvenly) {
  const ArmKinematics arm = ArmOf("left");
  const RigidTransform X_WG = arm.ToolPose(kReady);
  const RigidTransform goal(Matrix3(Eigen::AngleAxisd(0.4, Vector3::UnitZ()) * X_WG.rotation()),
                            X_WG.translation() + Vector3(0.05, 0.1, 0.1));
  const auto answer = MoveAlongLine(arm, kReady, goal, {.tool_speed = 0.05});
  ASSERT_TRUE(std::holds_alternative<JointTrajectory>(answer))
      << std::get<LineFault>(answer).reason;
  const auto& move = std::get<JointTrajectory>(answer);
  EXPECT_NEAR(move.seconds(), 0.15 / 0.05, 0.5);
  constexpr double kH = 0.01;
  for (double t = 0; t < move.seconds() - kH; t += kH) {
    const RigidTransform now = arm.ToolPose(SampleAt(move, t).positions);
    const RigidTransform next = arm.ToolPose(SampleAt(move, t + kH).positions);
    EXPECT_LE((next.translation() - now.translation()).norm() / kH, 0.05 * 1.001);
    // Rotation is proportional to distance.
    const double share = (now.translation() - X_WG.translation()).norm() / 0.15;
    EXPECT_NEAR(AngleBetween(X_WG.rotation(), now.rotation()), share * 0.4, 1e-3);
  }
}

TEST(MoveAlongLine, ReportsHowFarItGets) {
  const ArmKinematics arm = ArmOf("left");
  const RigidTransform X_WG = arm.ToolPose(kReady);
  const RigidTransform goal(X_WG.rotation(), X_WG.translation() + Vector3(2, 0, 0));
  const auto answer = MoveAlongLine(arm, kReady, goal);
  ASSERT_TRUE(std::holds_alternative<LineFault>(answer));
  const auto& fault = std::get<LineFault>(answer);
  EXPECT_GT(fault.fraction, 0.05);
  EXPECT_LT(fault.fraction, 0.5);
  const double way = (fault.X_WG.translation() - X_WG.translation()).norm();
  EXPECT_NEAR(way / 2, fault.fraction, 0.01);

  const auto nowhere = MoveAlongLine(arm, kReady, RigidTransform(Vector3(1e9, 0, 0)));
  EXPECT_EQ(std::get<LineFault>(nowhere).fraction, 0);
  EXPECT_EQ(std::get<JointTrajectory>(MoveAlongLine(arm, kReady, X_WG)).points.size(), 1u);
  EXPECT_THROW(MoveAlongLine(arm, kReady, X_WG, {.tool_speed = 0}), std::invalid_argument);
  EXPECT_THROW(MoveAlongLine(arm, std::vector(7, 3.0), X_WG), std::invalid_argument);
}

}  // namespace
}  // namespace smile::motion
