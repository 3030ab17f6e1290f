#include "motion/articulation_probe.h"

#include <gtest/gtest.h>

#include "robot/test/baxter.h"
#include "robot/test/solid_overlap.h"

namespace smile::robot {
namespace {

/// Brute force: returns two links that overlap by more than `depth` somewhere.
bool IsKnownToOverlap(const std::vector<double>& q, double depth) {
  const RobotModel& model = Baxter();
  const std::vector<RigidTransform> X_BaseL = LinkPoses(model, {}, q);
  const auto overlap = [&](int a, int b) {
    const RigidTransform X_BaseA = a < 0 ? RigidTransform() : X_BaseL[a];
    for (const scene::Solid& s : a < 0 ? model.base_solids : model.links[a].solids) {
      for (const scene::Solid& t : model.links[b].solids) {
        if (Overlap(s, X_BaseA * s.X_BS, t, X_BaseL[b] * t.X_BS, depth)) return true;
      }
    }
    return false;
  };
  for (int a = -1; a < model.num_joints(); ++a) {
    for (int b = a + 1; b < model.num_joints(); ++b) {
      const std::pair<int, int> pair{a, b};
      if (std::ranges::count(model.never_collide, pair) == 0 && overlap(a, b)) return true;
    }
  }
  return false;
}

TEST(ArticulationProbe, AgreesWithBruteForceOnWhatTouches) {
  motion::ArticulationProbe probe(MakeArticulationSpec(Baxter(), {}));
  std::mt19937 random(7);
  int num_free = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const std::vector<double> q = RandomConfiguration(Baxter(), &random);
    const auto overlap = probe.FirstOverlap(q);
    if (!overlap) ++num_free;
    // Brute force samples points 3 cm apart and may miss shallow overlaps.
    if (IsKnownToOverlap(q, 0.002)) {
      EXPECT_TRUE(overlap) << trial;
    } else if (overlap) {
      EXPECT_LT(overlap->depth, 0.03) << trial;
    }
    EXPECT_EQ(probe.FirstOverlap(q), overlap);  // independent of earlier queries
  }
  EXPECT_GT(num_free, 30);
  EXPECT_LT(num_free, 120);
}

TEST(ArticulationProbe, AnswersTheSameWhateverItWasAskedBefore) {
  motion::ArticulationProbe asked(MakeArticulationSpec(Baxter(), {}));
  std::mt19937 random(11);
  std::vector<double> q = Baxter().q_start;
  int num_overlaps = 0;
  for (int trial = 0; trial < 300; ++trial) {
    // One joint after the other: most links stand as they did.
    const std::size_t joint = random() % q.size();
    q[joint] = RandomConfiguration(Baxter(), &random)[joint];
    motion::ArticulationProbe fresh(MakeArticulationSpec(Baxter(), {}));
    const double depth = trial % 2 == 0 ? 0.0005 : 0.01;
    const auto overlap = asked.FirstOverlap(q, depth);
    EXPECT_EQ(overlap, fresh.FirstOverlap(q, depth)) << trial;
    EXPECT_EQ(asked.AllOverlaps(q), fresh.AllOverlaps(q)) << trial;
    if (overlap) ++num_overlaps;
  }
  EXPECT_GT(num_overlaps, 50);
  EXPECT_LT(num_overlaps, 250);
}

TEST(ArticulationProbe, FindsNamedPosesFreeUntilSomethingStandsInTheWay) {
  motion::ArticulationProbe alone(MakeArticulationSpec(Baxter(), {}));
  for (const NamedPose& pose : Baxter().poses) {
    EXPECT_FALSE(alone.FirstOverlap(pose.q)) << pose.name;
  }
  // A post where the left hand is.
  const std::vector<double>& q = FindPose(Baxter(), "zero")->q;
  const Arm& left = *FindArm(Baxter(), "left");
  const scene::Solid post{.shape = scene::Block{{0.1, 0.1, 0.5}},
                          .X_BS = FramePose(Baxter(), {}, q, left.tool)};
  motion::ArticulationProbe beside(MakeArticulationSpec(Baxter(), {}), {post});
  const auto overlap = beside.FirstOverlap(q);
  ASSERT_TRUE(overlap);
  EXPECT_EQ(overlap->other, motion::kEnvironment);
  EXPECT_GE(overlap->link, left.joints.front());
  EXPECT_LE(overlap->link, left.gripper->right_finger);
  EXPECT_THROW(beside.FirstOverlap(std::vector<double>(3)), std::invalid_argument);
}

}  // namespace
}  // namespace smile::robot
