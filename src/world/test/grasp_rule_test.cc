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
physics::LinkContact At(double side, double along, const Vector3& normal_in_world) {
  return {
      .body = kBlock, .p_WQ = {0, side * kOpening / 2, along}, .normal_in_world = normal_in_world};
}

std::vector<physics::BodyId> Grasped(const physics::LinkContact& left,
                                     const physics::LinkContact& right) {
  return GraspedBodies({&left, 1}, {&right, 1}, RigidTransform(), kOpening);
}

TEST(GraspRule, PointsMayDifferAlongTheFingersByElevenDegrees) {
  const double most = kOpening * std::tan(std::numbers::pi / 16);
  const physics::LinkContact left = At(1, 0, Vector3::UnitY());
  EXPECT_EQ(Grasped(left, At(-1, 0.999 * most, -Vector3::UnitY())), std::vector{kBlock});
  EXPECT_TRUE(Grasped(left, At(-1, 1.001 * most, -Vector3::UnitY())).empty());
}

TEST(GraspRule, NormalsMustFaceEachOther) {
  const physics::LinkContact left = At(1, 0, Vector3::UnitY());
  EXPECT_TRUE(Grasped(left, At(-1, 0, Vector3::UnitY())).empty());
  EXPECT_TRUE(Grasped(left, At(-1, 0, Vector3::UnitX())).empty()) << "its tip pushes";
  EXPECT_EQ(Grasped(left, At(-1, 0, Vector3(0.6, -0.8, 0))), std::vector{kBlock});
}

TEST(GraspRule, BothFingersMustTouchTheSame) {
  physics::LinkContact other = At(-1, 0, -Vector3::UnitY());
  other.body = physics::BodyId{8};
  EXPECT_TRUE(Grasped(At(1, 0, Vector3::UnitY()), other).empty());
}

std::vector<physics::BodyId> BetweenJaws(const physics::LinkContact& left,
                                         const physics::LinkContact& right) {
  return BodiesBetweenJaws({&left, 1}, {&right, 1});
}

TEST(JawRule, TheLineBetweenThePointsIsWithinBothFrictionCones) {
  // Jaws may close in any direction: the line, not the tool, says which.
  const Vector3 outwards = Vector3(0, 1, 0.5).normalized();
  const auto at = [&](double side, double angle) {
    const Vector3 normal = std::cos(angle) * side * outwards + std::sin(angle) * Vector3::UnitX();
    return physics::LinkContact{
        .body = kBlock, .p_WQ = side * 0.05 * outwards, .normal_in_world = normal};
  };
  const double cone = std::numbers::pi / 4;
  EXPECT_EQ(BetweenJaws(at(1, 0), at(-1, 0)), std::vector{kBlock});
  EXPECT_EQ(BetweenJaws(at(1, 0.99 * cone), at(-1, -0.99 * cone)), std::vector{kBlock});
  EXPECT_TRUE(BetweenJaws(at(1, 1.01 * cone), at(-1, 0)).empty());
  EXPECT_TRUE(BetweenJaws(at(1, 0), at(-1, 1.01 * cone)).empty());
  EXPECT_TRUE(BetweenJaws(at(-1, 0), at(-1, 0)).empty()) << "one point has no line";
  physics::LinkContact other = at(-1, 0);
  other.body = physics::BodyId{8};
  EXPECT_TRUE(BetweenJaws(at(1, 0), other).empty());
}

TEST(SuctionRule, AFaceClosesTheCupThatIsFlatOnItAndNearItsMiddle) {
  const auto at = [](double aside, double tilt, std::uint32_t body = kBlock.value) {
    // The tool looks along z, so the normal of a face before it points back.
    return physics::LinkContact{.body = physics::BodyId{body},
                                .p_WQ = {aside, 0, 0},
                                .normal_in_world = {std::sin(tilt), 0, -std::cos(tilt)}};
  };
  const auto held = [](std::vector<physics::LinkContact> contacts) {
    return BodyAtCup(contacts, RigidTransform(), 0.02);
  };
  const double flat = std::numbers::pi / 6;
  EXPECT_EQ(held({}), std::nullopt);
  EXPECT_EQ(held({at(0.019, 0.99 * flat)}), kBlock);
  EXPECT_EQ(held({at(0.021, 0)}), std::nullopt);
  EXPECT_EQ(held({at(0, 1.01 * flat)}), std::nullopt);
  EXPECT_EQ(held({at(0, std::numbers::pi)}), std::nullopt) << "behind the cup";
  EXPECT_EQ(held({at(0.01, 0, 3), at(0.005, 0, 4), at(0.015, 0, 5)}), physics::BodyId{4});
  EXPECT_EQ(held({at(0.01, 0, 3), at(-0.01, 0, 4)}), physics::BodyId{3}) << "the first of equals";
}

}  // namespace
}  // namespace smile::world
