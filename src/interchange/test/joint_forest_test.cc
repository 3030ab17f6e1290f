#include "interchange/joint_forest.h"

#include <gtest/gtest.h>

namespace smile::interchange {
namespace {

TEST(JointForest, AChainBetweenFixedEndsIsCutInItsMiddle) {
  ExportedWorld world;
  for (const double mass : {0.0, 0.0, 1.0, 1.0, 1.0}) {
    world.bodies.push_back({});
    world.bodies.back().spec.mass.mass = mass;
  }
  for (const auto& [a, b] : {std::pair{0, 2}, {2, 3}, {3, 4}, {4, 1}}) {
    world.joints.push_back({.a = a, .b = b});
  }
  const JointForest forest = ForestOf(world);
  EXPECT_EQ(forest.order, (std::vector<int>{0, 1, 2, 4, 3}));
  EXPECT_EQ(forest.nodes[4].parent, 1);
  EXPECT_EQ(forest.nodes[3].parent, 2);
  EXPECT_EQ(forest.closing, std::vector<int>{2}) << "that between the second and the third link";
}

TEST(JointForest, GroupsAreWhatJointsHoldTogether) {
  ExportedWorld world;
  world.bodies.resize(6);
  for (const auto& [a, b] : {std::pair{4, 5}, {1, 3}, {5, 1}}) {
    world.joints.push_back({.a = a, .b = b});
  }
  EXPECT_EQ(GroupsOf(world), (std::vector<std::vector<int>>{{0}, {1, 3, 4, 5}, {2}}));
}

}  // namespace
}  // namespace smile::interchange
