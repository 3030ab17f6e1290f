#include "studio/resting_place.h"

#include <gtest/gtest.h>

namespace smile::studio {
namespace {

scene::ObjectSpec Fixed(const std::string& id, const Vector3& size, const RigidTransform& X_WB) {
  scene::ObjectSpec object;
  object.whole = {.id = id, .X_PE = X_WB, .shape = scene::Block{size}};
  object.mass = 0;
  return object;
}

/// A ball beside a gentle slope, with a wall at its lower end.
sim::Simulation SlopeAndBall() {
  scene::SceneSpec scene;
  const Matrix3 R_WB(Eigen::AngleAxisd(DegreesToRadians(2), Vector3::UnitY()));
  scene.objects.push_back(Fixed("slope", {1.2, 0.3, 0.02}, RigidTransform(R_WB, {0, 0, 0.05})));
  scene.objects.push_back(Fixed("wall", {0.02, 0.3, 0.2}, RigidTransform(Vector3(0.5, 0, 0.1))));
  scene::ObjectSpec ball;
  ball.whole = {
      .id = "ball", .X_PE = RigidTransform(Vector3(0, 0.4, 0.05)), .shape = scene::Sphere{0.05}};
  scene.objects.push_back(ball);
  return sim::Simulation(scene);
}

TEST(RestingPlace, IsWhereAnObjectComesToRestEvenAfterALongTime) {
  sim::Simulation simulation = SlopeAndBall();
  const auto hand = sim::HandName::kLeft;
  ASSERT_FALSE(simulation.Apply(sim::Grasp{.hand = hand, .object = "ball"}));
  ASSERT_FALSE(simulation.Apply(sim::MoveTo{.hand = hand, .p_WH = {-0.45, 0, 0.15}}));
  for (int i = 0; i < 2 * sim::kTicksPerSecond; ++i) simulation.Tick();
  Rehearsal rehearsal;
  const RestingAttempt found = FindRestingPlace(simulation, hand, &rehearsal);
  ASSERT_TRUE(found.X_WB);
  EXPECT_GT(found.num_ticks, 2u * sim::kTicksPerSecond) << "it takes longer than that";
  ASSERT_FALSE(simulation.Apply(sim::Release{.hand = hand}));
  for (int i = 0; i < 10 * sim::kTicksPerSecond; ++i) simulation.Tick();
  const Vector3 rest =
      simulation.physics().body(simulation.tabletop().Find("ball")->body).pose_in_world() *
      Vector3::Zero();
  EXPECT_GT(rest.x(), 0.3) << "it rolled down";
  EXPECT_LT((found.X_WB->translation() - rest).norm(), 0.001);
}

}  // namespace
}  // namespace smile::studio
