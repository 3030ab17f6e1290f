#include "task/symmetry.h"

#include <gtest/gtest.h>

#include "structure_maker.h"

namespace smile::task {
namespace {

double LookedTurn(const scene::Shape& shape, const Vector3& angles_deg) {
  const Matrix3 start = RotationFromFixedAxes({0, 0, 33});
  return RadiansToDegrees(SymmetryOf(ObjectAt("x", shape, {0, 0, 0}))
                              .AngleBetween(start, start * RotationFromFixedAxes(angles_deg)));
}

TEST(Symmetry, IsThatOfTheShape) {
  constexpr double kNone = 1e-4;  // [deg]
  const scene::Block cube, plank{{0.1, 0.1, 0.4}}, brick{{0.1, 0.2, 0.4}};
  EXPECT_LT(LookedTurn(cube, {90, 180, -90}), kNone);
  EXPECT_NEAR(LookedTurn(cube, {0, 0, 60}), 30, kNone);
  EXPECT_LT(LookedTurn(plank, {0, 0, 90}), kNone);
  EXPECT_LT(LookedTurn(plank, {180, 0, 0}), kNone);
  EXPECT_NEAR(LookedTurn(plank, {90, 0, 0}), 90, kNone);
  EXPECT_NEAR(LookedTurn(brick, {0, 0, 90}), 90, kNone);
  EXPECT_LT(LookedTurn(brick, {0, 180, 0}), kNone);

  const scene::Cylinder cylinder;
  EXPECT_LT(LookedTurn(cylinder, {0, 71, 0}), kNone);
  EXPECT_LT(LookedTurn(cylinder, {180, 71, 0}), kNone);
  EXPECT_NEAR(LookedTurn(cylinder, {20, 0, 0}), 20, kNone);
  EXPECT_EQ(LookedTurn(scene::Sphere{}, {20, 30, 40}), 0);

  EXPECT_LT(LookedTurn(scene::Frustum{}, {0, 0, 120}), kNone);
  EXPECT_NEAR(LookedTurn(scene::Frustum{}, {0, 0, 60}), 60, kNone);
  EXPECT_NEAR(LookedTurn(scene::Frustum{.radius_top = 0, .sides = 32}, {180, 0, 0}), 180, kNone);
  EXPECT_LT(LookedTurn(scene::Ring{}, {180, 0, 17}), kNone);

  EXPECT_LT(LookedTurn(scene::Box{}, {0, 0, 90}), kNone);
  EXPECT_NEAR(LookedTurn(scene::Box{}, {180, 0, 0}), 180, kNone);
}

TEST(Symmetry, OfAnArrangementIsThatOfItsPiecesAndTheirColors) {
  const auto bar_of = [](const Color& left, const Color& right) {
    scene::Composite bar;
    bar.parts = {CubeAt("l", {-0.1, 0, 0}, left).whole, CubeAt("r", {0.1, 0, 0}, right).whole};
    return bar;
  };
  EXPECT_LT(LookedTurn(bar_of({}, {}), {0, 0, 180}), 1e-4);
  EXPECT_LT(LookedTurn(bar_of({}, {}), {90, 0, 0}), 1e-4);
  EXPECT_NEAR(LookedTurn(bar_of({}, {1, 0, 0}), {0, 0, 180}), 180, 1e-4);
}

TEST(Symmetry, RoundPartsAboutOneAxisAreARoundBody) {
  constexpr double kNone = 1e-4;  // [deg]
  const auto tool_of = [](double grip_x, double grip_z, const scene::Shape& blade) {
    const RigidTransform upright(RotationFromFixedAxes({90, 0, 0}), {grip_x, 0, grip_z});
    scene::Part grip = ObjectAt("grip", scene::Cylinder{.radius = 0.035}, {}).whole;
    grip.X_PE = upright;
    // The blade is nested: a part of a part.
    scene::Composite tip;
    tip.parts = {ObjectAt("blade", blade, {0, 0, -0.02}).whole};
    scene::Composite tool;
    tool.parts = {grip, ObjectAt("tip", tip, {0, 0, -0.03}).whole};
    return tool;
  };
  const scene::Ring blade{.radius_outer = 0.01, .radius_inner = 0, .sides = 24};
  EXPECT_LT(LookedTurn(tool_of(0, 0.05, blade), {0, 0, 28}), kNone);
  EXPECT_NEAR(LookedTurn(tool_of(0, 0.05, blade), {180, 0, 28}), 180, kNone);
  EXPECT_NEAR(LookedTurn(tool_of(0, 0.05, blade), {20, 0, 0}), 20, kNone);
  EXPECT_NEAR(LookedTurn(tool_of(0.001, 0.05, blade), {0, 0, 28}), 28, kNone) << "two axes";
  EXPECT_NEAR(LookedTurn(tool_of(0, 0.05, scene::Block{}), {0, 0, 28}), 28, kNone);
  EXPECT_LT(LookedTurn(tool_of(0, 0.05, scene::Sphere{}), {0, 0, 28}), kNone);

  const auto dumbbell_of = [](const Color& left, const Color& right, double radius_top) {
    const scene::Frustum weight{.radius_top = radius_top, .height = 0.05, .sides = 32};
    scene::Part mirrored = ObjectAt("r", weight, {0, 0, 0.1}, right).whole;
    mirrored.X_PE = RigidTransform(RotationFromFixedAxes({180, 0, 0}), {0, 0, 0.1});
    scene::Composite dumbbell;
    dumbbell.parts = {ObjectAt("l", weight, {0, 0, -0.1}, left).whole, mirrored};
    return dumbbell;
  };
  EXPECT_LT(LookedTurn(dumbbell_of({}, {}, 0.02), {180, 0, 28}), kNone);
  EXPECT_NEAR(LookedTurn(dumbbell_of({}, {1, 0, 0}, 0.02), {180, 0, 28}), 180, kNone);
}

TEST(Symmetry, ATiltIsNoTurnAboutTheVertical) {
  const Symmetry brick = SymmetryOf(ObjectAt("x", scene::Block{{0.1, 0.2, 0.4}}, {0, 0, 0}));
  const Matrix3 upright = Matrix3::Identity();
  EXPECT_NEAR(brick.TiltBetween(upright, RotationFromFixedAxes({0, 0, 50})), 0, 1e-6);
  EXPECT_NEAR(brick.TiltBetween(upright, RotationFromFixedAxes({90, 0, 50})),
              DegreesToRadians(90.0), 1e-6);
}

}  // namespace
}  // namespace smile::task
