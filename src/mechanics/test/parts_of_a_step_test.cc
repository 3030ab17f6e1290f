#include <gtest/gtest.h>

#include "mechanics/carried_load.h"
#include "mechanics/link_trees.h"
#include "mechanics/slider_damping.h"

namespace smile::mechanics {
namespace {

TEST(LinkTrees, LinksAtTheBaseAreTreesUnlessACouplingConnectsThem) {
  std::vector<scene::LinkSpec> links(5);
  links[1].parent = 0;
  links[4].parent = 1;
  links[3].mimic = scene::Mimic{.leader = 4};
  const LinkTrees trees = TreesOf(links);
  EXPECT_EQ(trees.sizes, (std::vector<int>{4, 1}));
  EXPECT_EQ(trees.places[2].tree, 1);
  EXPECT_EQ(trees.places[3].tree, 0);
  EXPECT_EQ(trees.places[3].index, 2);
  EXPECT_EQ(trees.places[4].index, 3);
  EXPECT_TRUE(TreesOf({}).sizes.empty());
}

TEST(CarriedLoads, ACarriedBodyBearsItsWholeGroupAndOthersBearNothing) {
  const scene::MassProperties mass = {.mass = 2, .inertia = Matrix3::Identity()};
  std::vector<LoadMember> members;
  for (unsigned i = 1; i <= 3; ++i) {
    members.push_back({.body = BodyId{i}, .mass = &mass, .p_WBcm = Vector3(i, 0, 0)});
  }
  members[0].is_carried = true;
  const std::vector<Joint> joints = {{JointId{1}, BallJointSpec{.a = BodyId{1}, .b = BodyId{2}}}};
  const std::vector<CarriedLoad> loads = CarriedLoads(members, joints);
  EXPECT_EQ(loads[0].mass, 2);
  EXPECT_EQ(loads[0].moment, 1.5 + 2);
  EXPECT_EQ(loads[1].mass, 0);
  EXPECT_TRUE(loads[1].is_with_carried);
  EXPECT_FALSE(loads[2].is_with_carried);
}

TEST(FractionKept, OnlyASoftOrDampedSliderLosesSpeed) {
  SliderJointSpec slider{.lower = -1, .upper = 1};
  EXPECT_EQ(FractionKept(slider, 0.9, 1, /*is_carried=*/false, 0.1), 1);
  slider.softness = 0.5;
  EXPECT_DOUBLE_EQ(FractionKept(slider, 0.9, 1, /*is_carried=*/false, 0.1), 0.5);
  EXPECT_EQ(FractionKept(slider, 0.9, -1, /*is_carried=*/false, 0.1), 1) << "away from the limit";
  slider.damping = 0.75;
  EXPECT_DOUBLE_EQ(FractionKept(slider, 0, 1, /*is_carried=*/false, 0.5), 0.5);
  EXPECT_EQ(FractionKept(slider, 0, 1, /*is_carried=*/true, 0.5), 1);
}

}  // namespace
}  // namespace smile::mechanics
