#include <gtest/gtest.h>

#include "world/tabletop.h"

namespace smile::world {
namespace {

scene::SceneSpec SceneWithChain(const Vector3& p_WStart, const Vector3& p_WEnd, int num_links) {
  scene::SceneSpec scene{.name = "chain"};
  scene::ChainSpec chain{
      .start_id = "a-start", .end_id = "a-end", .p_WStart = p_WStart, .p_WEnd = p_WEnd};
  for (int i = 0; i < num_links; ++i) chain.link_ids.push_back("a-link" + std::to_string(i));
  scene.objects = PiecesOf(chain, scene.meters_per_unit);
  scene.chains = {chain};
  return scene;
}

double WidestGap(const physics::World& world) {
  double widest = 0;
  for (const physics::Joint& joint : world.joints()) {
    const auto& ball = std::get<physics::BallJointSpec>(joint.spec);
    const Vector3 p_WQ = world.body(ball.a).pose_in_world() * ball.p_AQ;
    widest = std::max(widest, (p_WQ - world.body(ball.b).pose_in_world() * ball.p_BQ).norm());
  }
  return widest;
}

TEST(Chain, TooLongForItsEndsItBendsAndDoesNotBurst) {
  // 20 links of 0.1 m lie straight between anchors 1.985 m apart.
  physics::World world;
  const Tabletop tabletop(&world, SceneWithChain({1, 0, 0.5}, {-1, -0.1, 0.4}, 20));
  EXPECT_NEAR(WidestGap(world), 0.01, 0.001);
  double fastest = 0;
  for (int step = 0; step < 960; ++step) {
    world.Step();
    for (const Object& object : tabletop.objects()) {
      fastest = std::max(fastest, world.body(object.body).linear_velocity().norm());
    }
  }
  EXPECT_LT(fastest, 2.0) << "m/s";
  EXPECT_LT(WidestGap(world), 0.001) << "m";
}

TEST(Chain, FallsApartWhereALinkIsDestroyed) {
  physics::World world;
  Tabletop tabletop(&world, SceneWithChain({0.4, 0, 0.8}, {-0.4, 0, 0.8}, 10));
  EXPECT_EQ(world.joints().size(), 11u);
  tabletop.Destroy(*tabletop.Find("a-link5"));
  EXPECT_EQ(world.joints().size(), 9u);
  EXPECT_EQ(tabletop.Find("a-link5"), nullptr);
  for (int step = 0; step < 720; ++step) world.Step();
  const auto height_of = [&](const char* id) {
    return world.body(tabletop.Find(id)->body).pose_in_world().translation().z();
  };
  EXPECT_LT(height_of("a-link4"), 0.6) << "hangs from the start";
  EXPECT_LT(height_of("a-link6"), 0.6) << "hangs from the end";
  EXPECT_NEAR(height_of("a-start"), 0.8, 1e-12);
}

}  // namespace
}  // namespace smile::world
