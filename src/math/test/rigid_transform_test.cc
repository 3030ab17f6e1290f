#include "math/rigid_transform.h"

#include <gtest/gtest.h>

#include <random>

namespace smile {
namespace {

constexpr double kTolerance = 1e-14;  // [m]

class RigidTransforms : public testing::Test {
 protected:
  Vector3 Point() { return {normal_(random_), normal_(random_), normal_(random_)}; }
  RigidTransform Pose() {
    return {Quaternion(normal_(random_), normal_(random_), normal_(random_), normal_(random_))
                .normalized(),
            Point()};
  }

  std::mt19937 random_{4};
  std::normal_distribution<> normal_;
};

TEST_F(RigidTransforms, TurnThenMoveAPoint) {
  const RigidTransform X_AB(Quaternion(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3::UnitZ())),
                            Vector3(1, 0, 0));
  EXPECT_LT((X_AB * Vector3(1, 0, 0) - Vector3(1, 1, 0)).norm(), kTolerance);
}

TEST_F(RigidTransforms, ComposeLikeTheirActionsOnPoints) {
  for (int i = 0; i < 100; ++i) {
    const RigidTransform X_AB = Pose(), X_BC = Pose();
    const Vector3 p_CQ = Point();
    EXPECT_LT(((X_AB * X_BC) * p_CQ - X_AB * (X_BC * p_CQ)).norm(), kTolerance);
  }
}

TEST_F(RigidTransforms, AreUndoneByTheirInverse) {
  for (int i = 0; i < 100; ++i) {
    const RigidTransform X_AB = Pose();
    const Vector3 p_BQ = Point();
    EXPECT_LT((X_AB.inverse() * (X_AB * p_BQ) - p_BQ).norm(), kTolerance);
  }
}

TEST_F(RigidTransforms, HaveOneQuaternionEach) {
  for (int i = 0; i < 100; ++i) {
    const RigidTransform X_AB = Pose();
    const Quaternion q_AB = X_AB.quaternion();
    EXPECT_GE(q_AB.w(), 0);
    EXPECT_NEAR(q_AB.norm(), 1, kTolerance);
    EXPECT_LT((q_AB.toRotationMatrix() - X_AB.rotation()).norm(), kTolerance);
  }
}

TEST_F(RigidTransforms, AreEqualOnlyToTheLastBit) {
  const RigidTransform X_AB = Pose();
  EXPECT_EQ(X_AB, X_AB);
  EXPECT_FALSE(X_AB == RigidTransform(X_AB.rotation(), X_AB.translation() * (1 + 1e-15)));
  EXPECT_EQ(RigidTransform() * X_AB, X_AB);
}

}  // namespace
}  // namespace smile
