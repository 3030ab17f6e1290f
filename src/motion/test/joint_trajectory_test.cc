#include "motion/joint_trajectory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace smile::motion {
namespace {

constexpr double kTiny = 1e-9;

const std::vector<JointLimits> kTwoJoints{{-3, 3, 1.5, 3}, {-3, 3, 4, 8}};

JointTrajectory Straight(const std::vector<double>& from, const std::vector<double>& to,
                         double speed = 1) {
  return {{"a", "b"}, MoveStraight(from, to, kTwoJoints, speed)};
}

TEST(JointTrajectory, StraightMovesKeepAllLimitsAndUseOneOfThem) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-3, 3);
  for (int trial = 0; trial < 200; ++trial) {
    const double scale = trial % 2 == 0 ? 1 : 0.01;  // long ways and short ones
    const std::vector<double> from{anywhere(random), anywhere(random)};
    const std::vector<double> to{from[0] + scale * (anywhere(random) - from[0]),
                                 from[1] + scale * (anywhere(random) - from[1])};
    const JointTrajectory move = Straight(from, to, 0.5);
    const double step = move.seconds() / 1000;
    double most_used = 0;
    for (int k = 0; k <= 1000; ++k) {
      const TrajectoryPoint now = SampleAt(move, k * step), next = SampleAt(move, (k + 1) * step);
      for (int i = 0; i < 2; ++i) {
        const double acceleration = (next.velocities[i] - now.velocities[i]) / step;
        const double used = std::max(std::abs(now.velocities[i]) / kTwoJoints[i].max_velocity / 0.5,
                                     std::abs(acceleration) / kTwoJoints[i].max_acceleration);
        EXPECT_LE(used, 1 + 1e-6);
        most_used = std::max(most_used, used);
        // Both joints have come equally far.
        EXPECT_NEAR((now.positions[0] - from[0]) * (to[1] - from[1]),
                    (now.positions[1] - from[1]) * (to[0] - from[0]), kTiny);
      }
    }
    EXPECT_GT(most_used, 0.99);
    EXPECT_EQ(SampleAt(move, move.seconds()).positions, to);
  }
}

TEST(JointTrajectory, VelocitiesAreTheSlopesOfPositions) {
  const JointTrajectory move = Straight({0, 1}, {2, -1});
  for (double t = 0.05; t < move.seconds(); t += 0.1) {
    const double h = 1e-6;
    const TrajectoryPoint before = SampleAt(move, t - h), after = SampleAt(move, t + h);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(SampleAt(move, t).velocities[i],
                  (after.positions[i] - before.positions[i]) / (2 * h), 1e-5);
    }
  }
}

TEST(JointTrajectory, RestsBeforeItsStartAndAfterItsEnd) {
  JointTrajectory moving{{"a"}, {{0, {1}, {5}}, {1, {2}, {5}}}};
  EXPECT_EQ(SampleAt(moving, -1).positions, std::vector<double>{1});
  EXPECT_EQ(SampleAt(moving, -1).velocities, std::vector<double>{0});
  EXPECT_EQ(SampleAt(moving, 9).positions, std::vector<double>{2});
  EXPECT_EQ(SampleAt(moving, 9).velocities, std::vector<double>{0});
}

TEST(JointTrajectory, AMoveToWhereOneIsTakesNoTime) {
  EXPECT_EQ(Straight({1, 1}, {1, 1}).seconds(), 0);
}

TEST(JointTrajectory, NamesTheJointThatWouldLeaveItsLimits) {
  try {
    Straight({0, 0}, {0, 4});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "joint 1 would be at 4, expected -3 to 3");
  }
  EXPECT_THROW(Straight({0, 0}, {0, NAN}), std::invalid_argument);
  EXPECT_THROW(Straight({0, 0}, {1, 1}, 0), std::invalid_argument);
  EXPECT_THROW(SampleAt({}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace smile::motion
