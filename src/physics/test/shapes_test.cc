// Frusta and rings as bodies: contacts are at their faces, and holes are open.

#include <gtest/gtest.h>

#include <numbers>

#include "physics_fixture.h"

namespace smile::physics {
namespace {

constexpr double kSettled = 1e-4;  // [m]

class ShapesTest : public PhysicsFixture {
 protected:
  BodyId AddShape(const scene::Shape& shape, const RigidTransform& X_WB, double mass = 1) {
    const std::vector<scene::Solid> solids = scene::SolidsOf({.shape = shape});
    return world_.AddBody(
        {.solids = solids, .mass = scene::MassPropertiesOf(solids, mass), .X_WB = X_WB});
  }
  BodyId AddShape(const scene::Shape& shape, const Vector3& p_WB, double mass = 1) {
    return AddShape(shape, RigidTransform(p_WB), mass);
  }
  Vector3 PlaceOf(BodyId id) { return world_.body(id).pose_in_world().translation(); }
  double TiltOf(BodyId id) { return 1 - world_.body(id).pose_in_world().rotation()(2, 2); }
};

const scene::Ring kLyingRing{
    .radius_outer = 0.15, .radius_inner = 0.08, .height = 0.05, .sides = 32};

TEST_F(ShapesTest, AFrustumStandsWhereItWasPut) {
  AddTable();
  const BodyId stump =
      AddShape(scene::Frustum{.radius_top = 0.03, .radius_bottom = 0.06, .height = 0.1, .sides = 6},
               {0, 0, 0.05});
  const BodyId prism = AddShape(scene::Frustum{}, {0.3, 0, 0.05});
  const BodyId cone =
      AddShape(scene::Frustum{.radius_top = 0, .height = 0.08, .sides = 40}, {-0.3, 0, 0.04});
  StepSeconds(3);
  const std::vector<RigidTransform> settled = PosesOf({stump, prism, cone});
  StepSeconds(30);
  const std::vector<BodyId> all{stump, prism, cone};
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_LT((PlaceOf(all[i]) - settled[i].translation()).norm(), kSettled) << "creeps: " << i;
    EXPECT_LT(TiltOf(all[i]), 1e-5) << i;
  }
  EXPECT_LT((PlaceOf(stump) - Vector3(0, 0, 0.05)).norm(), kSettled);
  EXPECT_LT((PlaceOf(prism) - Vector3(0.3, 0, 0.05)).norm(), kSettled);
  EXPECT_LT((PlaceOf(cone) - Vector3(-0.3, 0, 0.04)).norm(), kSettled);
}

TEST_F(ShapesTest, ABallFallsThroughTheHoleOfALyingRing) {
  AddTable();
  const BodyId ring = AddShape(kLyingRing, {0, 0, 0.025});
  const BodyId ball = AddShape(scene::Sphere{0.04}, {0, 0, 0.3});
  StepSeconds(3);
  EXPECT_LT((PlaceOf(ball) - Vector3(0, 0, 0.04)).norm(), 1e-3);
  EXPECT_LT((PlaceOf(ring) - Vector3(0, 0, 0.025)).norm(), kSettled);
}

TEST_F(ShapesTest, AStaticRingIsHollow) {
  AddTable();
  const BodyId ring = AddShape(kLyingRing, {0, 0, 0.3}, /*mass=*/0);
  const BodyId ball = AddShape(scene::Sphere{0.04}, {0, 0, 0.6});
  StepSeconds(3);
  EXPECT_LT((PlaceOf(ball) - Vector3(0, 0, 0.04)).norm(), 1e-3);
  EXPECT_EQ(PlaceOf(ring).z(), 0.3);
}

TEST_F(ShapesTest, ABallTooLargeForTheHoleRestsOnItsRim) {
  AddTable();
  AddShape(kLyingRing, {0, 0, 0.025});
  const BodyId ball = AddShape(scene::Sphere{0.1}, {0, 0, 0.2});
  StepSeconds(4);
  // It touches the upper rim, a circle of 8 cm, where the sphere is 6 cm below its middle.
  EXPECT_NEAR(PlaceOf(ball).z(), 0.05 + 0.06, 2e-3);
}

TEST_F(ShapesTest, RingsStackOnAPeg) {
  AddTable();
  AddShape(scene::Frustum{.radius_top = 0.04, .radius_bottom = 0.04, .height = 0.3, .sides = 12},
           {0, 0, 0.15}, /*mass=*/0);
  std::vector<BodyId> rings;
  for (int i = 0; i < 3; ++i) {
    rings.push_back(AddShape(scene::Ring{.radius_outer = 0.1, .radius_inner = 0.05, .height = 0.04},
                             {0, 0, 0.03 + 0.05 * i}));
  }
  StepSeconds(4);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(PlaceOf(rings[i]).z(), 0.02 + 0.04 * i, 5e-4) << i;
}

TEST_F(ShapesTest, AnUprightRingRolls) {
  AddTable();
  constexpr double kRadius = 0.1, kPush = 0.6;
  const Matrix3 R_WB(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3::UnitX()));
  const BodyId ring = AddShape(
      scene::Ring{.radius_outer = kRadius, .radius_inner = 0.06, .height = 0.08, .sides = 64},
      RigidTransform(R_WB, Vector3(-0.6, 0, kRadius)));
  world_.body(ring).SetVelocity({kPush, 0, 0}, {0, kPush / kRadius, 0});
  StepSeconds(1);
  EXPECT_GT(PlaceOf(ring).x(), -0.6 + 0.3);
  EXPECT_NEAR(PlaceOf(ring).z(), kRadius, 1e-3) << "it is still upright";
}

}  // namespace
}  // namespace smile::physics
