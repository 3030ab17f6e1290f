#include "task/layout.h"

#include <gtest/gtest.h>

namespace smile::task {
namespace {

scene::ObjectSpec BlockAt(std::string id, const Vector3& p, const Color& color = {}) {
  return {
      .whole = {
          .id = std::move(id), .X_PE = RigidTransform(p), .color = color, .shape = scene::Block{}}};
}

TEST(RandomLayout, IsSeededAndKeepsItsDistance) {
  scene::SceneSpec scene{.name = "s",
                         .objects = {BlockAt("a", {0, 0, 0.05}), BlockAt("b", {0, 0, 0.05}),
                                     BlockAt("c", {0, 0, 0.05})}};
  EXPECT_EQ(RandomLayout(scene, 4), RandomLayout(scene, 4));
  EXPECT_FALSE(RandomLayout(scene, 4) == RandomLayout(scene, 5));
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto objects = RandomLayout(scene, seed).objects;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(
            (objects[i].pose_in_world().translation() - objects[j].pose_in_world().translation())
                .norm(),
            LayoutRegion().min_distance);
      }
    }
  }
  for (int i = 0; i < 50; ++i) scene.objects.push_back(BlockAt("x" + std::to_string(i), {0, 0, 0}));
  EXPECT_THROW(RandomLayout(scene, 1), std::invalid_argument);
}

}  // namespace
}  // namespace smile::task
