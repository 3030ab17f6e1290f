#include <gtest/gtest.h>

#include "model/relations.h"
#include "model/test/placed_objects.h"

namespace smile::model {
namespace {

/// Returns the support of a cube at this place, among a block, a crate, a ring and a plank across
/// the table's axes.
std::optional<Support> SupportOfCubeAt(const Vector3& p) {
  return SupportOf({},
                   {CubeAt("a", p), CubeAt("b", {0.3, 0, 0.05}),
                    ObjectAt("crate", scene::Box{{0.4, 0.4, 0.3}, 0.05}, {-0.4, 0, 0.15}),
                    ObjectAt("ring", scene::Ring{0.15, 0.1, 0.1, 12}, {0, 0.4, 0.05}),
                    ObjectAt("plank", scene::Block{{0.4, 0.05, 0.05}}, {0.5, 0.4, 0.025}, {}, 45)},
                   "a");
}

TEST(Support, IsTheHighestObjectBeneath) {
  EXPECT_EQ(SupportOfCubeAt({0, 0, 0.05}), Support());
  EXPECT_EQ(SupportOfCubeAt({0.35, 0.05, 0.16})->object, "b");
  EXPECT_TRUE(SupportOfCubeAt({0.35, 0.05, 0.16})->is_near());
  EXPECT_FALSE(SupportOfCubeAt({0.35, 0.05, 0.175})->is_near());
  EXPECT_NEAR(SupportOfCubeAt({0.35, 0.05, 0.5})->height, 0.35, 1e-12);
  EXPECT_EQ(SupportOfCubeAt({1.2, 0, 0.05}), std::nullopt) << "beyond the table's edge";
  EXPECT_EQ(SupportOf({}, {}, "a"), std::nullopt);
}

TEST(Support, AboveAContainerIsItsInside) {
  for (double z : {0.1, 0.4}) {
    const Support support = *SupportOfCubeAt({-0.4, 0, z});
    EXPECT_EQ(support.object, "crate");
    EXPECT_TRUE(support.is_inside);
    EXPECT_NEAR(support.height, z - 0.1, 1e-12);
  }
  const Support on_wall = *SupportOfCubeAt({-0.22, 0, 0.35});
  EXPECT_EQ(on_wall.object, "crate");
  EXPECT_FALSE(on_wall.is_inside) << "it lies on the crate's wall";
}

TEST(Support, AgreesWithTheRelationsAfterwards) {
  const Support in_ring = *SupportOfCubeAt({0, 0.4, 0.3});
  EXPECT_EQ(in_ring.object, "ring");
  EXPECT_TRUE(in_ring.is_inside);
  EXPECT_NEAR(in_ring.height, 0.25, 1e-12);
  // Beneath its bounds, but not beneath itself.
  EXPECT_EQ(SupportOfCubeAt({0.6, 0.3, 0.05})->object, "");
}

TEST(Support, IsInsideARingAlsoAtTheSeamsOfItsPieces) {
  // A seam is at y = 0, where rounding leaves a gap.
  for (int k = -40; k <= 40; ++k) {
    const std::vector<scene::ObjectSpec> objects{
        CubeAt("a", {0.4, k * 2e-18, 0.05}),
        ObjectAt("ring", scene::Ring{0.15, 0.1, 0.1, 32}, {0.4, 0, 0.05})};
    EXPECT_TRUE(SupportOf({}, objects, "a")->is_inside) << k;
  }
}

TEST(Support, IsTheInnermostOfNestedContainers) {
  const std::vector<scene::ObjectSpec> objects{
      ObjectAt("crate", scene::Box{{0.6, 0.6, 0.4}, 0.02}, {0, 0, 0.2}),
      ObjectAt("cup", scene::Box{{0.2, 0.2, 0.2}, 0.01}, {0, 0, 0.12}), CubeAt("a", {0, 0, 0.18})};
  EXPECT_EQ(SupportOf({}, objects, "a")->object, "cup");
  EXPECT_EQ(SupportOf({}, objects, "cup")->object, "crate");
}

}  // namespace
}  // namespace smile::model
