#include "mechanics/joint_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace smile::mechanics {
namespace {

std::vector<JointGroups::Member> MakeBodies(std::uint32_t count, std::uint32_t num_static) {
  std::vector<JointGroups::Member> bodies;
  for (std::uint32_t id = 1; id <= count; ++id) bodies.push_back({BodyId{id}, id <= num_static});
  return bodies;
}

/// Joints between random pairs, of which at least one is not static.
std::vector<Joint> MakeJoints(std::uint32_t count, std::uint32_t num_bodies,
                              std::uint32_t num_static, std::mt19937* random) {
  std::vector<Joint> joints;
  while (joints.size() < count) {
    const std::uint32_t a = 1 + (*random)() % num_bodies, b = 1 + (*random)() % num_bodies;
    if (a == b || std::max(a, b) <= num_static) continue;
    const JointId id{static_cast<std::uint32_t>(joints.size() + 1)};
    joints.push_back({id, BallJointSpec{.a = BodyId{a}, .b = BodyId{b}}});
  }
  return joints;
}

TEST(JointGraph, AgreesWithTheGroupsOfAllBodies) {
  constexpr std::uint32_t kStatic = 3, kBodies = 20;
  const auto bodies = MakeBodies(kBodies, kStatic);
  const auto is_static = [&bodies](BodyId id) { return bodies[id.value - 1].is_static; };
  std::mt19937 random(1);
  for (std::uint32_t count = 0; count < 30; ++count) {
    const std::vector<Joint> joints = MakeJoints(count, kBodies, kStatic, &random);
    const JointGraph graph(joints);
    const JointGroups groups(bodies, joints, /*only_fixed=*/false);
    for (std::uint32_t one = kStatic + 1; one <= kBodies; ++one) {
      const int group = groups.group_of(BodyId{one});
      std::vector<BodyId> moving;
      bool is_anchored = false;
      for (BodyId id : graph.ConnectedWith(BodyId{one}, is_static)) {
        is_static(id) ? void(is_anchored = true) : moving.push_back(id);
      }
      std::vector<BodyId> expected;
      for (const auto& member : bodies) {
        if (groups.group_of(member.body) == group) expected.push_back(member.body);
      }
      EXPECT_EQ(moving, expected) << "of body " << one << " with " << count << " joints";
      EXPECT_EQ(is_anchored, groups.is_anchored(group));
    }
  }
}

TEST(JointGraph, EndsPathsAtStaticBodiesAndPassesOverOneJoint) {
  const BodyId post{1}, a{2}, b{3}, held{4};
  const JointId first{1}, second{2};
  const std::vector<Joint> joints = {{first, BallJointSpec{.a = a, .b = post}},
                                     {second, FixedJointSpec{.a = b, .b = post}},
                                     {JointId{3}, FixedJointSpec{.a = a, .b = b}},
                                     {JointId{4}, WeldSpec{.body = held}}};
  const auto is_post = [post](BodyId id) { return id == post; };
  const auto ends_nowhere = [](BodyId) { return false; };
  EXPECT_EQ(JointGraph(joints).ConnectedWith(a, is_post), (std::vector{post, a, b}));
  EXPECT_EQ(JointGraph(joints).ConnectedWith(post, is_post), std::vector{post});
  EXPECT_EQ(JointGraph(joints, JointId{3}).ConnectedWith(a, is_post), (std::vector{post, a}));
  EXPECT_EQ(JointGraph(joints, JointId{3}).ConnectedWith(a, ends_nowhere),
            (std::vector{post, a, b}));
  EXPECT_EQ(JointGraph(joints).ConnectedWith(held, is_post), std::vector{held});
}

}  // namespace
}  // namespace smile::mechanics
