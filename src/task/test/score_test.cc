#include "task/score.h"

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "math/angles.h"

namespace smile::task {
namespace {

scene::ObjectSpec BlockAt(std::string id, const Vector3& p, const Color& color = {}) {
  return {
      .whole = {
          .id = std::move(id), .X_PE = RigidTransform(p), .color = color, .shape = scene::Block{}}};
}

/// Three high, and one that stands apart.
Goal Tower() {
  return {{BlockAt("a", {0.1, 0, 0.05}), BlockAt("b", {0.1, 0, 0.15}), BlockAt("c", {0.1, 0, 0.25}),
           BlockAt("d", {0.4, 0.1, 0.05})}};
}

std::map<std::string, std::string> Itself(const Goal& goal) {
  std::map<std::string, std::string> match;
  for (const auto& object : goal.objects) match[object.id()] = object.id();
  return match;
}

ObjectPoses Moved(const Goal& goal, double angle_deg, const Vector3& shift) {
  ObjectPoses poses;
  const RigidTransform motion(RotationFromFixedAxes({0, 0, angle_deg}), shift);
  for (const auto& object : goal.objects) poses[object.id()] = motion * object.pose_in_world();
  return poses;
}

TEST(Score, IsPerfectWhereverTheStructureStands) {
  for (double angle_deg : {0.0, 37.0, 160.0, -90.0}) {
    const Score score =
        ScoreOutcome(Tower(), Itself(Tower()), Moved(Tower(), angle_deg, {-0.3, 0.2, 0}));
    EXPECT_TRUE(score.is_rebuilt());
    EXPECT_LT(score.mean_error, 1e-9);
  }
}

TEST(Score, OneFallenBlockDoesNotBlameTheOthers) {
  ObjectPoses outcome = Moved(Tower(), 20, {0.2, 0.1, 0});
  outcome["c"] = RigidTransform(Vector3(0.7, 0.7, 0.05));
  const Score score = ScoreOutcome(Tower(), Itself(Tower()), outcome);
  EXPECT_DOUBLE_EQ(score.share, 0.75);
  EXPECT_LT(score.errors.at("a"), 0.001);
  EXPECT_GT(score.errors.at("c"), 0.2);
}

TEST(Score, AStructureLiftedOrTiltedIsNotRebuilt) {
  ObjectPoses outcome = Moved(Tower(), 0, {0, 0, 0.1});
  EXPECT_EQ(ScoreOutcome(Tower(), Itself(Tower()), outcome).share, 0);
}

TEST(Score, TheWrongOrderIsNotRebuilt) {
  ObjectPoses outcome = Moved(Tower(), 0, {0, 0, 0});
  std::swap(outcome["a"], outcome["b"]);
  EXPECT_DOUBLE_EQ(ScoreOutcome(Tower(), Itself(Tower()), outcome).share, 0.5);
}

TEST(Score, SmallErrorsAreMeasured) {
  ObjectPoses outcome = Moved(Tower(), 0, {0, 0, 0});
  outcome["d"] = RigidTransform(Vector3(0.41, 0.1, 0.05));
  const Score score = ScoreOutcome(Tower(), Itself(Tower()), outcome);
  EXPECT_TRUE(score.is_rebuilt());
  EXPECT_GT(score.mean_error, 0.001);
  EXPECT_LT(score.mean_error, 0.005);
}

TEST(MatchObjects, PrefersIdsThenLooks) {
  const Color red{1, 0, 0}, blue{0, 0, 1};
  const Goal goal{{BlockAt("a", {0, 0, 0}, red), BlockAt("b", {0, 0, 0}, blue)}};
  const scene::SceneSpec scene{
      .name = "new",
      .objects = {BlockAt("b", {0, 0, 0}, red), BlockAt("x", {0, 0, 0}, blue),
                  BlockAt("a", {0, 0, 0}, red)}};
  const auto match = MatchObjects(goal, scene);
  EXPECT_EQ(match.at("a"), "a");
  EXPECT_EQ(match.at("b"), "x");
  EXPECT_THROW(MatchObjects(goal, {.name = "empty"}), InputError);
}

}  // namespace
}  // namespace smile::task
