#include "task/failure_reason.h"

#include <gtest/gtest.h>

#include "structure_maker.h"

namespace smile::task {
namespace {

const Structure& Pair() {
  static const Structure kPair{
      .objects = {CubeAt("low", {0, 0, 0.05}, {1, 0, 0}), CubeAt("high", {0, 0, 0.15}, {0, 1, 0})},
      .order = {"low", "high"}};
  return kPair;
}

std::string WordOf(const Episode& episode, const ProgramEnd& program = {.status = "exited"},
                   const Structure& structure = Pair()) {
  const auto reason = FailureReasonOf(structure, episode, CompareWith(structure, episode), program);
  return reason ? reason->code + ": " + reason->text : "";
}

/// Where the upper block ends.
Episode EndingAt(const Vector3& p, const Vector3& angles_deg = {0, 0, 0}) {
  std::vector<scene::ObjectSpec> outcome = Pair().objects;
  outcome[1].whole.X_PE = RigidTransform(RotationFromFixedAxes(angles_deg), p);
  return EpisodeTo(outcome);
}

TEST(FailureReason, IsEmptyForASuccess) { EXPECT_EQ(WordOf(EndingAt({0.01, 0, 0.15})), ""); }

TEST(FailureReason, AProgramThatDidNotEndByItselfNeverSucceeds) {
  for (const char* status : {"stopped", "running"}) {
    EXPECT_EQ(WordOf(EndingAt({0.01, 0, 0.15}), {.status = status}),
              "time_up: the brain was still running when the episode ended");
  }
}

TEST(FailureReason, AProgramThatFailedNeverSucceeds) {
  EXPECT_EQ(WordOf(EndingAt({0.01, 0, 0.15}), {.status = "failed", .message = "in init"}),
            "brain_failed: the brain failed: in init");
}

TEST(FailureReason, HeldObjectsAreNotPlaced) {
  Episode episode = EndingAt({0, 0, 0.15});
  Carry("high", episode.begin.objects[1].pose_in_world(), episode.end.objects[1].pose_in_world(),
        &episode);
  EXPECT_EQ(WordOf(episode), "");
  episode.contacts.pop_back();
  EXPECT_EQ(WordOf(episode), "still_held: high is still held");
  EXPECT_EQ(CompareWith(Pair(), episode).score, 0.5);
}

TEST(FailureReason, IsTheFirstThatApplies) {
  Episode untouched = EndingAt({0, 0, 0.15});
  untouched.end.objects[1] = untouched.begin.objects[1];
  EXPECT_EQ(WordOf(untouched), "never_taken: high is still at its start position");
  EXPECT_EQ(WordOf(untouched, {.status = "running"}),
            "time_up: the brain was still running when the episode ended");
  EXPECT_EQ(WordOf(EndingAt({0.2, 0, 0.05})), "toppled: high lies 100 mm lower than it should");
  EXPECT_EQ(WordOf(EndingAt({0, 0, 0.15}, {40, 0, 0})), "toppled: high is tilted by 40 degrees");
  EXPECT_EQ(WordOf(EndingAt({0.04, 0, 0.15})),
            "misplaced: high is 40 mm from its place, turned by 0 degrees");
  EXPECT_EQ(WordOf(EndingAt({0.3, 0, 0.15})), "not_placed: high is 300 mm from its place");

  Episode fallen = EndingAt({0, -3, -0.5});
  fallen.contacts.push_back({{.kind = sim::EventKind::kFell, .object = "high"}, 3, {}});
  EXPECT_EQ(WordOf(fallen, {.status = "running"}), "fell_off_table: high fell off the table");
  EXPECT_EQ(WordOf(fallen, {.status = "failed", .message = "no"}),
            "brain_failed: the brain failed: no");
}

TEST(FailureReason, AMissingEffectIsOne) {
  Structure structure = Pair();
  structure.objects.push_back(ObjectAt("box", scene::Box{}, {0.5, 0.3, 0.05}));
  structure.effects = {ContainerEffect{"high", "box", true}};
  const Episode episode = EpisodeTo(structure.objects);
  EXPECT_DOUBLE_EQ(CompareWith(structure, episode).score, 0.75);
  EXPECT_EQ(WordOf(episode, {.status = "exited"}, structure),
            "effect_missing: not achieved: high put into box");
}

}  // namespace
}  // namespace smile::task
