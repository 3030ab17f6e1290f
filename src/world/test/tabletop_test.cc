#include "world/tabletop.h"

#include <gtest/gtest.h>

namespace smile::world {
namespace {

scene::SceneSpec SceneWith(std::vector<scene::ObjectSpec> objects) {
  return {.name = "test", .objects = std::move(objects)};
}

scene::ObjectSpec BlockAt(std::string id, const Vector3& p_WB, double mass = 1) {
  return {.whole = {.id = std::move(id), .X_PE = RigidTransform(p_WB), .shape = scene::Block{}},
          .mass = mass};
}

TEST(Tabletop, ObjectsComeToRestOnTheTable) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({BlockAt("b", {0.3, 0.2, 0.1})}));
  for (int i = 0; i < 960; ++i) world.Step();
  const RigidTransform X_WB = world.body(tabletop.Find("b")->body).pose_in_world();
  EXPECT_NEAR(X_WB.translation().z(), 0.05, 1e-4);
}

TEST(Tabletop, TheFloorCatchesWhatLeavesTheTable) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({BlockAt("b", {1.5, 0, 0.1})}));
  for (int i = 0; i < 1440; ++i) world.Step();
  EXPECT_NEAR(world.body(tabletop.Find("b")->body).pose_in_world().translation().z(),
              -kFloorDepth + 0.05, 1e-3);
}

TEST(Tabletop, AStaticObjectStaysInTheAir) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({BlockAt("shelf", {0, 0, 0.5}, /*mass=*/0)}));
  for (int i = 0; i < 480; ++i) world.Step();
  EXPECT_EQ(world.body(tabletop.Find("shelf")->body).pose_in_world().translation().z(), 0.5);
}

TEST(Tabletop, PosesAndPicturesCountTheSameFrames) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({BlockAt("a", {0, 0, 1}), BlockAt("b", {1, 0, 1})}));
  scene::VisualModel model;
  scene::FramePoses poses(1);
  tabletop.AppendVisuals(&model);
  tabletop.AppendPoses(&poses);
  EXPECT_EQ(model.num_frames, static_cast<int>(poses.size()));
  EXPECT_EQ(model.object_names, (std::vector<std::string>{"", "table", "a", "b"}));
  EXPECT_EQ(tabletop.Find("c"), nullptr);
}

}  // namespace
}  // namespace smile::world
