#include "model/relations.h"

#include <gtest/gtest.h>

#include "model/test/placed_objects.h"

namespace smile::model {
namespace {

using Relations = std::vector<Relation>;
constexpr auto kOn = Relation::Kind::kOn;
constexpr auto kIn = Relation::Kind::kIn;

TEST(Relations, AreWithAllThatAThingStandsOn) {
  const scene::Block plank{{0.4, 0.1, 0.1}};
  EXPECT_EQ(RelationsOf({}, {CubeAt("a", {0, 0, 0.05}), CubeAt("b", {0.3, 0, 0.05}),
                             ObjectAt("p", plank, {0.15, 0, 0.151}), CubeAt("air", {0.15, 0, 0.35}),
                             CubeAt("floor", {0, 3, 0.05})}),
            (Relations{{"a", kOn, ""}, {"b", kOn, ""}, {"p", kOn, "a"}, {"p", kOn, "b"}}));
}

TEST(Relations, AreNotWithTheNeighborsOfWhatIsTurned) {
  // Turned by 45 degrees, the upper block's cuboid along the axes reaches over both.
  EXPECT_EQ(RelationsOf({}, {CubeAt("a", {0, 0, 0.05}), CubeAt("corner", {0.1, 0.1, 0.05}),
                             ObjectAt("top", scene::Block{}, {0, 0, 0.15}, {}, 45)}),
            (Relations{{"a", kOn, ""}, {"corner", kOn, ""}, {"top", kOn, "a"}}));
}

TEST(Relations, AThingLiesInWhatIsAroundIt) {
  const scene::Box box{{0.4, 0.3, 0.1}, 0.005};
  const scene::Ring ring{.radius_outer = 0.1, .radius_inner = 0.08, .height = 0.05};
  EXPECT_EQ(
      RelationsOf({}, {ObjectAt("box", box, {0, 0, 0.05}, {}, 30), CubeAt("in", {0.02, 0, 0.056}),
                       CubeAt("above", {0.02, 0, 0.155}), ObjectAt("ring", ring, {0.5, 0, 0.025}),
                       ObjectAt("peg", scene::Sphere{}, {0.5, 0.01, 0.05})}),
      (Relations{{"box", kOn, ""},
                 {"in", kIn, "box"},
                 {"above", kOn, "in"},
                 {"ring", kOn, ""},
                 {"peg", kIn, "ring"}}));
  // Objects stand on a low tray, not in it.
  EXPECT_EQ(RelationsOf({}, {ObjectAt("tray", scene::Box{{0.4, 0.3, 0.02}, 0.005}, {0, 0, 0.01}),
                             CubeAt("c", {0, 0, 0.055})}),
            (Relations{{"tray", kOn, ""}, {"c", kOn, "tray"}}));
}

TEST(IsAround, ARingIsAroundAPostHoweverHigh) {
  const scene::Ring ring{.radius_outer = 0.1, .radius_inner = 0.08, .height = 0.05};
  const scene::ObjectSpec around = ObjectAt("ring", ring, {0.5, 0, 0.025});
  const scene::Block post{{0.05, 0.05, 0.4}};
  EXPECT_TRUE(IsAround(around, ObjectAt("post", post, {0.5, 0.02, 0.2})));
  EXPECT_FALSE(IsAround(around, ObjectAt("beside", post, {0.63, 0, 0.2})));
  EXPECT_FALSE(IsAround(around, ObjectAt("above", post, {0.5, 0, 0.25})));
  EXPECT_FALSE(IsAround(ObjectAt("post", post, {0.5, 0.02, 0.2}), around));
}

}  // namespace
}  // namespace smile::model
