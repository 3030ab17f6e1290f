// Sliders, from a SliderSpec to their motion.

#include <algorithm>
#include <functional>

#include "workshop.h"

namespace smile::world {
namespace {

class SliderTest : public WorkshopTest {
 protected:
  /// Two objects on a rail; their places in the world follow from it.
  void StartSlider(scene::SliderSpec slider, scene::ObjectSpec first, scene::ObjectSpec second) {
    first.whole.X_PE = slider.pose_of_first();
    second.whole.X_PE = slider.pose_of_second();
    scene::SceneSpec scene{.name = "slider"};
    scene.objects = {std::move(first), std::move(second)};
    scene.sliders = {slider};
    Start(scene);
  }
  /// Carries an object by hand with this velocity for some time.
  void Carry(std::string_view id, const Vector3& velocity, double seconds) {
    BodyOf(id).SetCarried(true);
    for (int i = 0; i < seconds * 480; ++i) {
      BodyOf(id).SetVelocity(velocity, Vector3::Zero());
      world_->Step();
    }
    BodyOf(id).SetVelocity(Vector3::Zero(), Vector3::Zero());
  }
};

TEST_F(SliderTest, CountsItsOffsetAlongMinusXOfTheRail) {
  // The rail's x is the world's y.
  StartSlider({.X_WJ = {RotationFromFixedAxes({0, 0, 90}), Vector3(0.2, 0.1, 0.5)},
               .X_JA = RigidTransform(Vector3(0, 0.3, 0)),
               .X_JB = {RotationFromFixedAxes({0, 90, 0}), Vector3(0.02, 0, 0.1)},
               .min_offset = -0.05,
               .max_offset = 0.2,
               .initial_offset = 0.1,
               .restitution = 0},
              ObjectAt("rail", scene::Block{}, Vector3::Zero(), /*mass=*/0),
              ObjectAt("cart", scene::Block{{0.05, 0.05, 0.05}}, Vector3::Zero()));
  // At offset 0 the cart would be at y = 0.1 + 0.02.
  EXPECT_LT((PositionOf("rail") - Vector3(-0.1, 0.1, 0.5)).norm(), 1e-9);
  EXPECT_LT((PositionOf("cart") - Vector3(0.2, 0.12 - 0.1, 0.6)).norm(), 1e-9);
  const Matrix3 R_WCart = PoseOf("cart").rotation();

  BodyOf("cart").SetVelocity({0, -1, 0}, Vector3::Zero());
  double lowest = 1;
  for (int i = 0; i < 480; ++i) {
    world_->Step();
    lowest = std::min(lowest, PositionOf("cart").y());
  }
  EXPECT_NEAR(lowest, 0.12 - 0.2, 0.002);
  BodyOf("cart").SetVelocity({0, 1, 0}, Vector3::Zero());
  double highest = -1;
  for (int i = 0; i < 480; ++i) {
    world_->Step();
    highest = std::max(highest, PositionOf("cart").y());
  }
  EXPECT_NEAR(highest, 0.12 + 0.05, 0.002);
  EXPECT_LT((PositionOf("cart") - Vector3(0.2, PositionOf("cart").y(), 0.6)).norm(), 0.001)
      << "nothing sideways, nothing falls";
  EXPECT_TRUE(PoseOf("cart").rotation().isApprox(R_WCart, 1e-3)) << "no turning";
}

class DrawerTest : public SliderTest {
 protected:
  /// A heavy drawer that comes out of its light case along the world's x, by up to 0.42 m.
  DrawerTest() {
    StartSlider({.X_WJ = {RotationFromFixedAxes({0, 0, 180}), Vector3(-0.5, 0, 0.125)},
                 .max_offset = 0.42,
                 .initial_offset = 0,
                 .damping = 1},
                ObjectAt("case", scene::Box{{0.5, 0.3, 0.25}, 0.02}, Vector3::Zero(), 100),
                ObjectAt("drawer", scene::Block{{0.4, 0.2, 0.1}}, Vector3::Zero(), 500));
    StepSeconds(0.5);
    x_case_ = PositionOf("case").x();
    x_drawer_ = PositionOf("drawer").x();
  }
  double Moved(std::string_view id) {
    return PositionOf(id).x() - (id == "case" ? x_case_ : x_drawer_);
  }

  double x_case_ = 0, x_drawer_ = 0;
};

TEST_F(DrawerTest, LeavesItsCaseWhereItIsUpToTheLimit) {
  EXPECT_NEAR(x_case_, -0.5, 0.001);
  Carry("drawer", {0.3, 0, 0}, 1.38);
  EXPECT_NEAR(Moved("drawer"), 0.414, 0.003);
  EXPECT_LT(std::abs(Moved("case")), 0.002) << "pulled by nothing but its damping";
  Carry("drawer", {0.3, 0, 0}, 0.5);
  EXPECT_NEAR(Moved("drawer"), 0.564, 0.005);
  EXPECT_NEAR(Moved("case"), 0.564 - 0.42, 0.005) << "the limit drags it";
  Carry("drawer", Vector3::Zero(), 0.3);
  const double x_dragged = Moved("case");
  Carry("drawer", {-0.3, 0, 0}, 1.3);
  EXPECT_NEAR(Moved("case"), x_dragged, 0.004) << "it goes in again";
  Carry("drawer", {-0.3, 0, 0}, 0.58);
  EXPECT_NEAR(Moved("case"), Moved("drawer"), 0.003) << "the other limit pushes it back";
  EXPECT_NEAR(Moved("case"), 0, 0.006);
}

TEST_F(DrawerTest, WithDampingOneStaysWhereItIsPut) {
  Carry("drawer", {0.3, 0, 0}, 0.5);
  BodyOf("drawer").SetCarried(false);
  const double offset = PositionOf("drawer").x() - PositionOf("case").x();
  EXPECT_NEAR(offset, 0.15, 0.003);
  BodyOf("drawer").SetVelocity({0.3, 0, 0}, Vector3::Zero());
  StepSeconds(0.5);
  EXPECT_NEAR(PositionOf("drawer").x() - PositionOf("case").x(), offset, 0.005);
}

TEST_F(SliderTest, ALidDragsItsBoxAtItsLimitAndLiftsIt) {
  StartSlider({.X_WJ = RigidTransform(Vector3(0, 0, 0.135)),
               .X_JB = RigidTransform(Vector3(0, 0, 0.15)),
               .max_offset = 0.6,
               .initial_offset = 0.37},
              ObjectAt("box", scene::Box{{0.8, 0.6, 0.27}, 0.03}, Vector3::Zero(), 10),
              ObjectAt("lid", scene::Block{{0.8, 0.6, 0.03}}, Vector3::Zero(), 1));
  EXPECT_NEAR(PositionOf("lid").x(), -0.37, 1e-9);
  Carry("lid", {0.3, 0, 0}, 1.2);
  EXPECT_NEAR(PositionOf("lid").x(), -0.01, 0.003);
  EXPECT_NEAR(PositionOf("box").x(), 0, 0.003);
  Carry("lid", {0.3, 0, 0}, 0.2);
  EXPECT_NEAR(PositionOf("lid").x(), 0.05, 0.003);
  EXPECT_NEAR(PositionOf("box").x(), 0.05, 0.004) << "dragged";
  Carry("lid", {0, 0, 0.3}, 1);
  EXPECT_GT(PositionOf("lid").z(), 0.5);
  EXPECT_NEAR(PositionOf("box").z(), PositionOf("lid").z() - 0.15, 0.005) << "it hangs on its lid";
  EXPECT_GT(PoseOf("box").rotation()(2, 2), 0.999) << "level";
}

}  // namespace
}  // namespace smile::world
