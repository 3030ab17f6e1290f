#include "motion/limit_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/trajectory_shape.h"

namespace smile::motion {
namespace {

const std::vector<JointLimits> kOneJoint{{-1, 1, 2, 10}};

TEST(CheckLimits, FindsTheMomentBetweenPointsAtWhichAJointIsWorst) {
  // Thrown up at 3 rad/s against -2 rad/s2: highest in the middle, at 1.5 s, 2.25 rad above 0.
  const JointTrajectory thrown{{"a"}, {{0, {0}, {3}}, {3, {0}, {-3}}}};
  const std::vector<LimitBreach> breaches = CheckLimits(thrown, kOneJoint);
  ASSERT_EQ(breaches.size(), 2u);
  EXPECT_EQ(breaches[0], (LimitBreach{0, "a", LimitedQuantity::kVelocity, 3, 2}));
  EXPECT_EQ(breaches[1].quantity, LimitedQuantity::kPosition);
  EXPECT_NEAR(breaches[1].seconds, 1.5, 1e-12);
  EXPECT_NEAR(breaches[1].value, 2.25, 1e-12);
  EXPECT_EQ(breaches[1].limit, 1);
}

TEST(CheckLimits, FindsTheFastestMomentAndTheHardestPush) {
  // From rest to rest over 0.8 rad in 0.4 s: 3 rad/s half way, 30 rad/s2 at both ends.
  const JointTrajectory jerk{{"a"}, {{0, {0}, {0}}, {0.4, {-0.8}, {0}}}};
  const std::vector<LimitBreach> breaches = CheckLimits(jerk, kOneJoint);
  ASSERT_EQ(breaches.size(), 2u);
  EXPECT_EQ(breaches[0].quantity, LimitedQuantity::kAcceleration);
  EXPECT_NEAR(breaches[0].value, -30, 1e-9);
  EXPECT_EQ(breaches[0].limit, -10);
  EXPECT_EQ(breaches[1].quantity, LimitedQuantity::kVelocity);
  EXPECT_NEAR(breaches[1].seconds, 0.2, 1e-12);
  EXPECT_NEAR(breaches[1].value, -3, 1e-12);
  EXPECT_EQ(ToString({0, "a", LimitedQuantity::kVelocity, -3, -2}),
            "a: velocity is -3 rad/s, expected at least -2 rad/s");
  std::vector<JointLimits> slide = kOneJoint;
  slide.front().slides = true;
  EXPECT_EQ(ToString(CheckLimits({{"a"}, {{0, {1.5}, {0}}}}, slide).front()),
            "a: position is 1.5 m, expected at most 1 m");
}

TEST(CheckLimits, AMoveAtTheLimitsKeepsThem) {
  const JointTrajectory move{{"a"}, MoveStraight(std::vector{-1.0}, std::vector{1.0}, kOneJoint)};
  EXPECT_TRUE(CheckLimits(move, kOneJoint).empty());
  EXPECT_TRUE(CheckLimits({{"a"}, {}}, kOneJoint).empty());
}

TEST(CheckLimits, ForgivesTheRoundingOfMovesToWhereTheJointIs) {
  // Inverse kinematics gives the same angles again but for their last bits: from
  // 1e-8 rad down to a single bit, where the place half way is not half way.
  for (double distance = 1e-8; distance > 1e-16; distance /= 3) {
    const double from = 0.7;
    const JointTrajectory move{
        {"a"}, MoveStraight(std::vector{from}, std::vector{from + distance}, kOneJoint)};
    EXPECT_TRUE(CheckLimits(move, kOneJoint).empty()) << distance;
  }
  // Ten times too fast is no rounding, even where the motion is short.
  JointTrajectory fast{{"a"}, MoveStraight(std::vector{0.7}, std::vector{0.7 + 1e-8}, kOneJoint)};
  ScaleTime(0.1, &fast);
  EXPECT_FALSE(CheckLimits(fast, kOneJoint).empty());
}

TEST(CheckLimits, RefusesWhatIsNoTrajectory) {
  EXPECT_THROW(CheckLimits({{"a", "b"}, {}}, kOneJoint), std::invalid_argument);
  EXPECT_THROW(CheckLimits({{"a"}, {{0, {0, 1}, {0}}}}, kOneJoint), std::invalid_argument);
  EXPECT_THROW(CheckLimits({{"a"}, {{0, {NAN}, {0}}}}, kOneJoint), std::invalid_argument);
  EXPECT_THROW(CheckLimits({{"a"}, {{0, {0}, {0}}, {0, {1}, {0}}}}, kOneJoint),
               std::invalid_argument);
}

}  // namespace
}  // namespace smile::motion
