#include "scene/joined.h"

#include <gtest/gtest.h>

namespace smile::scene {
namespace {

ObjectSpec BlockCalled(const std::string& id) { return {.whole = {.id = id, .shape = Block{}}}; }

/// A slider of two members behind a block, and a string.
SceneSpec Mechanisms(const std::string& prefix) {
  SceneSpec scene{.name = prefix};
  for (const char* name : {"block", "case", "drawer"}) {
    scene.objects.push_back(BlockCalled(prefix + name));
  }
  scene.sliders.push_back({.id = prefix + "rail", .first_object = 1});
  ChainSpec chain{.id = prefix + "rope",
                  .start_id = prefix + "rope-start",
                  .end_id = prefix + "rope-end",
                  .link_ids = {prefix + "rope-link0"},
                  .p_WEnd = {0, 0.5, 0},
                  .first_object = 3};
  for (ObjectSpec& piece : PiecesOf(chain, kMetersPerUnit)) scene.objects.push_back(piece);
  scene.chains.push_back(chain);
  return scene;
}

TEST(Joined, KeepsThePlacesOfTheFirstAndMovesThoseOfTheSecond) {
  const SceneSpec first = Mechanisms("a_"), second = Mechanisms("b_");
  SceneSpec joined = Joined(first, second);
  ASSERT_EQ(joined.objects.size(), 12u);
  EXPECT_EQ(joined.objects[joined.sliders[0].first_object].id(), "a_case");
  EXPECT_EQ(joined.objects[joined.sliders[1].first_object].id(), "b_case");
  EXPECT_EQ(joined.objects[joined.chains[1].first_object].id(), "b_rope-start");
  joined.objects.resize(6);
  joined.sliders.resize(1);
  joined.chains.resize(1);
  EXPECT_EQ(joined, first);
}

TEST(IdsOf, FindsThemInAllThatIsNested) {
  Composite composite;
  composite.parts = {{.id = "part", .X_PE = {}, .shape = Block{}}, {.X_PE = {}, .shape = Block{}}};
  composite.guests = {{.id = "guest"}};
  composite.hosts = {{.id = "host"}};
  CustomControl control;
  control.states = {{.name = "", .parts = {{.id = "knob", .X_PE = {}, .shape = Block{}}}}};
  composite.parts.push_back({.id = "dial", .X_PE = {}, .shape = control});
  SceneSpec scene = Mechanisms("");
  scene.objects.push_back({.whole = {.id = "whole", .X_PE = {}, .shape = composite}});
  EXPECT_EQ(IdsOf(scene), (std::set<std::string>{"block", "case", "dial", "drawer", "guest", "host",
                                                 "knob", "part", "rail", "rope", "rope-end",
                                                 "rope-link0", "rope-start", "whole"}));
}

}  // namespace
}  // namespace smile::scene
