#include "scene/bounds.h"

#include <gtest/gtest.h>

#include "math/angles.h"

namespace smile::scene {
namespace {

TEST(Bounds, AreAsSmallAsTurnedShapesAllow) {
  const RigidTransform X_AS(RotationFromFixedAxes({0, 0, 45}), {1, 0, 0});
  const double half_diagonal = std::sqrt(2.0) * 0.05;
  const Bounds block = BoundsOf(SolidShape(Block{{0.1, 0.1, 0.2}}), X_AS);
  EXPECT_TRUE(block.low.isApprox(Vector3(1 - half_diagonal, -half_diagonal, -0.1)));
  EXPECT_TRUE(block.high.isApprox(Vector3(1 + half_diagonal, half_diagonal, 0.1)));
  // Its axis y lies halfway between those of A.
  const Bounds rod = BoundsOf(SolidShape(Cylinder{.radius = 0.01, .length = 0.2}), X_AS);
  const double reach = (0.1 + 0.01) * std::sqrt(0.5);
  EXPECT_TRUE(rod.high.isApprox(Vector3(1 + reach, reach, 0.01)));
}

TEST(Bounds, MeetOnlyWhatIsNearAlongEveryAxis) {
  const Bounds one{.low = Vector3::Zero(), .high = Vector3::Ones()};
  const Bounds beside{.low = {1.1, 0, 0}, .high = {2, 1, 1}};
  EXPECT_FALSE(one.Meets(beside));
  EXPECT_TRUE(one.Meets(beside, 0.2));
  EXPECT_FALSE(one.Meets(Bounds(), 0.2));
  EXPECT_TRUE(Bounds().is_empty());
}

}  // namespace
}  // namespace smile::scene
