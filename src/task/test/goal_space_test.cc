#include "task/goal_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/uniform.h"
#include "structure_maker.h"
#include "task/neighbors.h"

namespace smile::task {
namespace {

/// Two stacks of two, of which the blue cubes look alike.
Structure Stacks() {
  const Color blue{0, 0, 1};
  Structure structure{.objects = {CubeAt("a", {0, 0, 0.05}), CubeAt("b", {0, 0, 0.15}, blue),
                                  CubeAt("c", {0.3, 0, 0.05}), CubeAt("d", {0.3, 0, 0.15}, blue)},
                      .order = {"b", "d"}};
  structure.neighbors = NeighborsOf(structure);
  return structure;
}

/// Some of the cubes elsewhere, and the whole anywhere.
Episode RandomOutcome(const Structure& structure, std::mt19937_64* random) {
  std::vector<scene::ObjectSpec> objects =
      Moved(structure.objects, Uniform(random, -180, 180),
            {Uniform(random, -0.5, 0.5), Uniform(random, -0.5, 0.5), 0});
  for (scene::ObjectSpec& object : objects) {
    if (Uniform(random, 0, 1) > 0.5) continue;
    const Vector3 shift(Uniform(random, -0.04, 0.04), Uniform(random, -0.04, 0.04), 0);
    object.whole.X_PE = RigidTransform(shift) * object.pose_in_world();
  }
  return EpisodeTo(objects);
}

TEST(GoalSpace, ScoresWhatWasAchievedAsTheOutcomeIsScored) {
  const Structure structure = Stacks();
  const GoalSpace space(structure);
  GoalComparer comparer(&space);
  std::mt19937_64 random(1);
  int num_different = 0;
  double last = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Episode outcome = RandomOutcome(structure, &random);
    const GoalScore score = comparer.Compare(space.Achieved(outcome), space.Desired(outcome));
    ASSERT_EQ(score.score, CompareWith(structure, outcome).score) << "trial " << trial;
    num_different += score.score != last;
    last = score.score;
  }
  EXPECT_GT(num_different, 20);
}

TEST(GoalSpace, EveryOutcomeAchievesItself) {
  const GoalSpace space(Stacks());
  GoalComparer comparer(&space);
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<double> goal = space.Achieved(RandomOutcome(space.structure(), &random));
    const GoalScore score = comparer.Compare(goal, goal);
    EXPECT_TRUE(score.is_achieved());
    EXPECT_EQ(score.relations, 1);
    EXPECT_NEAR(score.closeness, 1, 1e-6);
  }
}

TEST(GoalSpace, AHeldObjectIsNotPlacedAndAFaultCounts) {
  const GoalSpace space(Stacks());
  GoalComparer comparer(&space);
  const std::vector<double> desired = space.Desired(EpisodeTo(space.structure().objects));
  EXPECT_EQ(desired.size(), space.size());
  EXPECT_EQ(space.Names(1)[7], "a.released");
  std::vector<double> achieved = desired;
  achieved[7] = 0;
  EXPECT_EQ(comparer.Compare(achieved, desired).score, 0.75);
  EXPECT_EQ(comparer.Compare(achieved, desired).relations, 0.75);
  achieved[7] = 1;
  achieved.back() = 1;
  EXPECT_EQ(comparer.Compare(achieved, desired).score, 0.8);
}

TEST(GoalSpace, ALandmarkDeterminesThePlace) {
  Structure structure = Stacks();
  structure.anchor = Anchor::kLandmark;
  structure.landmark = "a";
  const GoalSpace space(structure);
  GoalComparer comparer(&space);
  std::vector<scene::ObjectSpec> start = structure.objects;
  start[0].whole.X_PE = RigidTransform(Vector3(0.1, 0.1, 0.05));
  start[2].whole.X_PE = RigidTransform(Vector3(-0.6, 0.1, 0.05));
  const std::vector<scene::ObjectSpec> there = Moved(structure.objects, 0, {0.1, 0.1, 0});
  const Episode right = EpisodeBetween(start, there);
  const std::vector<double> desired = space.Desired(right);
  EXPECT_NEAR(desired[0], 0.1, 1e-9);
  EXPECT_TRUE(comparer.Compare(space.Achieved(right), desired).is_achieved());
  const Episode wrong = EpisodeBetween(start, Moved(structure.objects, 0, {0.2, 0.3, 0}));
  EXPECT_FALSE(comparer.Compare(space.Achieved(wrong), desired).is_achieved());
}

TEST(GoalSpace, RefusesWhatIsNoGoal) {
  const GoalSpace space(Stacks());
  GoalComparer comparer(&space);
  const std::vector<double> goal = space.Desired(EpisodeTo(space.structure().objects));
  const auto refuses = [&](std::vector<double> bad, const std::string& why) {
    try {
      (void)comparer.Compare(goal, bad);
      ADD_FAILURE() << "expected: " << why;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
    EXPECT_TRUE(comparer.Compare(goal, goal).is_achieved());
  };
  refuses({1, 2}, "desired_goal has 2 numbers, expected 33");
  std::vector<double> bad = goal;
  bad[1] = NAN;
  refuses(bad, "desired_goal[1] is not finite");
  bad = goal;
  std::fill(bad.begin() + 3, bad.begin() + 7, 0);
  refuses(bad, "quaternion of length 0");
}

}  // namespace
}  // namespace smile::task
