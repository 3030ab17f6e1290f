#include "mechanics/joint_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace smile::mechanics {
namespace {

TEST(JointOrder, IsTheSameWhicheverJointsAreLeftOut) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<JointOrder::Entry> all, present;
    for (int joint = 0; joint < 30; ++joint) all.push_back({joint, static_cast<int>(random() % 6)});
    const std::vector<int> places = JointOrder().PlacesOf(all);
    JointOrder order;
    std::vector<int> expected;
    for (const JointOrder::Entry& entry : all) {
      // Whole islands are left out.
      if (entry.island % 2 == round % 2) {
        order.LeaveOut(entry);
      } else {
        present.push_back(entry);
        expected.push_back(places[static_cast<std::size_t>(entry.joint)]);
      }
    }
    EXPECT_EQ(order.PlacesOf(present), expected);
    std::vector<int> sorted = places;
    std::ranges::sort(sorted);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(sorted[static_cast<std::size_t>(i)], i);
  }
}

TEST(JointOrder, ReversesEqualJointsLikeBullet) {
  const std::vector<JointOrder::Entry> two = {{1, 5}, {2, 5}};
  EXPECT_EQ(JointOrder().PlacesOf(two), (std::vector<int>{1, 0}));
}

}  // namespace
}  // namespace smile::mechanics
