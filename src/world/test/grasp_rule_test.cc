#include "world/grasp_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace smile::world {
namespace {

constexpr double kOpening = 0.1;
const physics::BodyId kBlock{7};

/// Returns the contact of a finger on one side of the opening, at this depth along it and with this
/// normal.
physics::Contact At(double side, double along, const Vector3& normal_in_world) {
  return {
      .body = kBlock, .p_WQ = {0, side * kOpening / 2, along}, .normal_in_world = normal_in_world};
}

std::vector<physics::BodyId> Grasped(const physics::Contact& left, const physics::Contact& right) {
  return GraspedBodies({&left, 1}, {&right, 1}, RigidTransform(), kOpening);
}

TEST(GraspRule, PointsMayDifferAlongTheFingersByElevenDegrees) {
  const double most = kOpening * std::tan(std::numbers::pi / 16);
  const physics::Contact left = At(1, 0, Vector3::UnitY());
  EXPECT_EQ(Grasped(left, At(-1, 0.999 * most, -Vector3::UnitY())), std::vector{kBlock});
  EXPECT_TRUE(Grasped(left, At(-1, 1.001 * most, -Vector3::UnitY())).empty());
}

TEST(GraspRule, NormalsMustFaceEachOther) {
  const physics::Contact left = At(1, 0, Vector3::UnitY());
  EXPECT_TRUE(Grasped(left, At(-1, 0, Vector3::UnitY())).empty());
  EXPECT_TRUE(Grasped(left, At(-1, 0, Vector3::UnitX())).empty()) << "its tip pushes";
  EXPECT_EQ(Grasped(left, At(-1, 0, Vector3(0.6, -0.8, 0))), std::vector{kBlock});
}

TEST(GraspRule, BothFingersMustTouchTheSame) {
  physics::Contact other = At(-1, 0, -Vector3::UnitY());
  other.body = physics::BodyId{8};
  EXPECT_TRUE(Grasped(At(1, 0, Vector3::UnitY()), other).empty());
}

}  // namespace
}  // namespace smile::world
