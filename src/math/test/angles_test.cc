#include "math/angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace smile {
namespace {

constexpr double kAngleTolerance = 1e-9;  // [deg]
constexpr double kMatrixTolerance = 1e-12;

double DistanceOf(const Matrix3& a, const Matrix3& b) { return (a - b).cwiseAbs().maxCoeff(); }

TEST(FixedAxes, TurnAboutXThenYThenZ) {
  using Turn = Eigen::AngleAxisd;
  const Vector3 angles_deg(30, -70, 110);
  const Matrix3 expected =
      (Turn(DegreesToRadians(110), Vector3::UnitZ()) *
       Turn(DegreesToRadians(-70), Vector3::UnitY()) * Turn(DegreesToRadians(30), Vector3::UnitX()))
          .toRotationMatrix();
  EXPECT_LT(DistanceOf(RotationFromFixedAxes(angles_deg), expected), kMatrixTolerance);
}

TEST(FixedAxes, AreExactAtQuarterTurns) {
  Matrix3 expected;
  expected << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_EQ(RotationFromFixedAxes({0, 0, 90}), expected);
  EXPECT_EQ(RotationFromFixedAxes({0, 0, -270}), expected);
  EXPECT_EQ(RotationFromFixedAxes({360, -720, 450}), expected);
}

TEST(FixedAxes, RoundTripAsTheSameAngles) {
  std::mt19937 random(1);
  std::uniform_real_distribution<> turn(-179.9, 179.9), tilt(-89, 89);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 angles_deg(turn(random), tilt(random), turn(random));
    const Vector3 found = FixedAxesAngles(RotationFromFixedAxes(angles_deg));
    EXPECT_LT((found - angles_deg).cwiseAbs().maxCoeff(), kAngleTolerance) << angles_deg;
  }
}

TEST(FixedAxes, GiveBackEveryRotationInTheirRange) {
  std::mt19937 random(2);
  std::normal_distribution<> normal;
  for (int i = 0; i < 1000; ++i) {
    const Matrix3 R = Quaternion(normal(random), normal(random), normal(random), normal(random))
                          .normalized()
                          .toRotationMatrix();
    const Vector3 angles_deg = FixedAxesAngles(R);
    EXPECT_LT(DistanceOf(RotationFromFixedAxes(angles_deg), R), kMatrixTolerance);
    EXPECT_LE(std::abs(angles_deg.x()), 180);
    EXPECT_LE(std::abs(angles_deg.y()), 90);
    EXPECT_LE(std::abs(angles_deg.z()), 180);
  }
}

TEST(FixedAxes, PutEverythingIntoTheLastAngleInGimbalLock) {
  const auto angles_of = [](double a, double b, double c) {
    return FixedAxesAngles(RotationFromFixedAxes({a, b, c}));
  };
  EXPECT_LT((angles_of(30, 90, 50) - Vector3(0, 90, 20)).norm(), kAngleTolerance);
  EXPECT_LT((angles_of(30, -90, 50) - Vector3(0, -90, 80)).norm(), kAngleTolerance);
  EXPECT_LT((angles_of(-170, 90, 170) - Vector3(0, 90, -20)).norm(), kAngleTolerance)
      << "the last angle stays within 180";
  EXPECT_LT((angles_of(30, 89, 50) - Vector3(30, 89, 50)).norm(), kAngleTolerance)
      << "a degree beside it nothing is lost";
}

TEST(RotationVector, TurnsTheOneIntoTheOther) {
  std::mt19937 random(3);
  std::normal_distribution<> normal;
  for (int i = 0; i < 1000; ++i) {
    const auto quaternion = [&] {
      return Quaternion(normal(random), normal(random), normal(random), normal(random))
          .normalized();
    };
    const Quaternion from = quaternion(), to = quaternion();
    const Vector3 v = RotationVectorBetween(from, to);
    EXPECT_LE(v.norm(), std::numbers::pi + kMatrixTolerance) << "the short way round";
    const Quaternion reached(Eigen::AngleAxisd(v.norm(), v.normalized()) * from);
    EXPECT_LT(DistanceOf(reached.toRotationMatrix(), to.toRotationMatrix()), kMatrixTolerance);
  }
}

TEST(RotationVector, IsSteadyWithoutRotation) {
  const Quaternion q = Quaternion(1, 2, 3, 4).normalized();
  EXPECT_LT(RotationVectorBetween(q, q).norm(), 1e-15);
  const Quaternion same(-q.w(), -q.x(), -q.y(), -q.z());
  EXPECT_LT(RotationVectorBetween(q, same).norm(), 1e-15) << "q and -q are one rotation";
  const double tiny = 1e-10;
  const Quaternion beside(Eigen::AngleAxisd(tiny, Vector3::UnitX()) * q);
  EXPECT_LT((RotationVectorBetween(q, beside) - tiny * Vector3::UnitX()).norm(), 1e-15);
}

}  // namespace
}  // namespace smile
