#include <gtest/gtest.h>

#include "physics_fixture.h"

namespace smile::physics {
namespace {

TEST(Overlap, IsResolvedAtWalkingSpeedAtAnyDepth) {
  PhysicsWorldBuilder builder;
  for (const double depth : {0.01, 0.03, 0.09}) {
    World world;
    world.AddBody(builder.BlockSpec({1, 1, 0.1}, RigidTransform(Vector3(0, 0, -0.05)), 0));
    const BodyId block = world.AddBody(
        builder.BlockSpec({0.1, 0.1, 0.1}, RigidTransform(Vector3(0, 0, 0.05 - depth)), 1));
    double fastest = 0;
    for (int step = 0; step < 480; ++step) {
      world.Step();
      fastest = std::max(fastest, world.body(block).linear_velocity().norm());
    }
    EXPECT_LT(fastest, 0.7) << "m/s, from " << depth;
    EXPECT_NEAR(world.body(block).pose_in_world().translation().z(), 0.05, 0.001);
  }
}

}  // namespace
}  // namespace smile::physics
