#include "math/camera_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace smile {
namespace {

constexpr double kPixelTolerance = 1e-9;

TEST(CameraIntrinsics, PutTheFieldOfViewFromTheTopEdgeToTheBottomEdge) {
  const double angle = std::numbers::pi / 3;
  const auto camera = CameraIntrinsics::FromVerticalFieldOfView(640, 480, angle);
  const double half_height = std::tan(angle / 2);  // at z = 1
  EXPECT_NEAR(ProjectToPixel(camera, {0, -half_height, 1}).y(), 0, kPixelTolerance);
  EXPECT_NEAR(ProjectToPixel(camera, {0, half_height, 1}).y(), 480, kPixelTolerance);
  EXPECT_NEAR(ProjectToPixel(camera, {half_height * 640 / 480, 0, 1}).x(), 640, kPixelTolerance);
}

TEST(CameraIntrinsics, ShowTheAxisInTheMiddleAtAnyDistance) {
  const auto camera = CameraIntrinsics::FromVerticalFieldOfView(200, 150, 1);
  for (double z : {0.1, 1.0, 100.0}) {
    EXPECT_EQ(ProjectToPixel(camera, {0, 0, z}), Eigen::Vector2d(100, 75));
  }
}

TEST(CameraIntrinsics, RefuseImpossibleCameras) {
  const auto make = CameraIntrinsics::FromVerticalFieldOfView;
  EXPECT_THROW(make(0, 480, 1), std::invalid_argument);
  EXPECT_THROW(make(640, 8193, 1), std::invalid_argument);
  EXPECT_THROW(make(640, 480, 0), std::invalid_argument);
  EXPECT_THROW(make(640, 480, std::numbers::pi), std::invalid_argument);
  EXPECT_THROW(make(640, 480, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(CameraIntrinsics, SeeAnAngleFromLeftToRight) {
  const auto camera = CameraIntrinsics::FromHorizontalFieldOfView(640, 400, DegreesToRadians(80.0));
  EXPECT_NEAR(ProjectToPixel(camera, {std::tan(DegreesToRadians(40.0)), 0, 1}).x(), 640,
              kPixelTolerance);
  EXPECT_EQ(camera.fx, camera.fy);
  EXPECT_EQ(camera.cy, 200);
}

TEST(LookAt, ShowsThePointInTheMiddleAndTheWorldUpright) {
  const Vector3 p_WQ(0.3, -0.2, 0.1);
  const RigidTransform X_WC = LookAt({1, -2, 1.5}, p_WQ);
  const auto camera = CameraIntrinsics::FromVerticalFieldOfView(640, 480, 1);
  const auto pixel_of = [&](const Vector3& p_W) {
    return ProjectToPixel(camera, X_WC.inverse() * p_W);
  };
  EXPECT_LT((pixel_of(p_WQ) - Eigen::Vector2d(320, 240)).norm(), kPixelTolerance);
  const Eigen::Vector2d above = pixel_of(p_WQ + Vector3(0, 0, 0.1));
  EXPECT_NEAR(above.x(), 320, kPixelTolerance);
  EXPECT_LT(above.y(), 240) << "up in the world is up in the image, and rows count downwards";
  EXPECT_NEAR(X_WC.rotation().determinant(), 1, 1e-12);
}

TEST(LookAt, HasXToTheRightAndYAwayFromTheUsersPlace) {
  const RigidTransform X_WC = LookAt({0, -2, 0}, {0, 0, 0});
  Matrix3 expected;
  expected.col(0) = Vector3::UnitX();
  expected.col(1) = -Vector3::UnitZ();
  expected.col(2) = Vector3::UnitY();
  EXPECT_LT((X_WC.rotation() - expected).norm(), 1e-15);
}

TEST(LookAt, WorksStraightDownAndRefusesItsOwnPlace) {
  const RigidTransform X_WC = LookAt({0, 0, 2}, {0, 0, 0});
  EXPECT_EQ(Vector3(X_WC.rotation().col(0)), Vector3::UnitX());
  EXPECT_EQ(Vector3(X_WC.rotation().col(2)), -Vector3::UnitZ());
  EXPECT_THROW(LookAt({1, 1, 1}, {1, 1, 1}), std::invalid_argument);
}

TEST(LookAt, TurnsTheImageUntilItsTopIsUp) {
  const RigidTransform X_WC = LookAt({0, 0, 2}, {0, 0, 0}, {3, 0, 1});
  EXPECT_LT((X_WC.rotation().col(1) + Vector3::UnitX()).norm(), 1e-15);
  EXPECT_THROW(LookAt({0, 0, 0}, {2, 0, 0}, {1, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace smile
