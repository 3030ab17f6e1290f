#include "experiment/run.h"

#include <limits>
#include <vector>

#include "base/diagnostic.h"
#include "experiment_fixture.h"
#include "recording/recording.h"
#include "recording/time_range.h"
#include "task/demonstrated_structure.h"

namespace smile::experiment {
namespace {

using RunTest = ExperimentTest;

/// Cancels at the n-th poll.
Callbacks CancelledAtPoll(int n) {
  return {.is_cancelled = [n, polls = 0]() mutable { return ++polls >= n; }};
}

TEST_F(RunTest, EndsAfterExactlyTheTicksOfItsSeconds) {
  const RunResult half = experiment::Run({.scene = Pair(), .seconds = 0.5});
  EXPECT_EQ(half.ticks, 30u);
  EXPECT_EQ(half.seconds, 0.5);
  const RunResult start = experiment::Run({.scene = Pair(), .seconds = 0});
  EXPECT_EQ(start.ticks, 0u);
  EXPECT_EQ(start.objects["b"]["position"], Json({2.0, -3.0, 0.5}));
}

TEST_F(RunTest, EndsWithItsScriptUnlessSecondsAreGiven) {
  const sim::Script script = ScriptOf("{\"do\":\"wait\",\"seconds\":0.25}\n");
  EXPECT_EQ(experiment::Run({.scene = Pair(), .script = script}).ticks, 15u);
  EXPECT_EQ(experiment::Run({.scene = Pair(), .script = script, .seconds = 1}).ticks, 60u);
  EXPECT_EQ(experiment::Run({.scene = Pair(), .script = script, .max_seconds = 0.1}).ticks, 6u);
}

TEST_F(RunTest, ReportsTheLineThatTimeWasTooShortFor) {
  const sim::Script script =
      ScriptOf("{\"do\":\"wait\",\"seconds\":1}\n{\"hand\":\"left\",\"do\":\"release\"}\n");
  std::vector<std::string> messages;
  experiment::Run(
      {.scene = Pair(), .script = script, .seconds = 0.5},
      {.on_message = [&](std::string_view message) { messages.emplace_back(message); }});
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("script.jsonl:1: the time limit was reached before this line"),
            std::string::npos)
      << messages[0];
}

TEST_F(RunTest, ReportsProgressOfItsStep) {
  std::vector<double> times;
  experiment::Run({.scene = Pair(), .seconds = 0.1, .label = "waiting"},
                  {.on_progress = [&](const std::string& step, double done, double total) {
                    EXPECT_EQ(step, "waiting");
                    EXPECT_EQ(total, 0.1);
                    times.push_back(done);
                  }});
  ASSERT_EQ(times.size(), 6u);
  EXPECT_TRUE(std::ranges::is_sorted(times));
  EXPECT_NEAR(times.back(), 0.1, 1e-12);
}

TEST_F(RunTest, ProgressCountsTheObjectsInPlace) {
  const task::Structure goal = task::StructureOf(recording::OpenRecording(RecordStacking()));
  const auto last_step = [&](const sim::Script& script) {
    std::string last;
    experiment::Run({.scene = Pair(), .script = script, .seconds = 2, .goal = &goal},
                    {.on_progress = [&](const std::string& step, double, double) { last = step; }});
    return last;
  };
  EXPECT_EQ(last_step(ScriptOf("{\"do\":\"wait\",\"seconds\":2}\n")),
            "running, 0 of 2 objects in place");
  EXPECT_EQ(last_step(Stacking()), "running, 2 of 2 objects in place");
}

TEST_F(RunTest, RecordingAndPacingChangeNoResult) {
  const RunPlan plain{.scene = Pair(), .script = Stacking(), .seconds = 0.5};
  RunPlan recorded = plain, paced = plain;
  recorded.record = root_ / "demo";
  recorded.has_pictures = false;
  paced.is_realtime = true;
  const RunResult result = experiment::Run(plain);
  EXPECT_EQ(experiment::Run(recorded).state_hash, result.state_hash);
  const RunResult late = experiment::Run(paced);
  EXPECT_EQ(late.state_hash, result.state_hash);
  EXPECT_GE(late.wall_seconds, 0.5 - 0.01);
}

TEST_F(RunTest, AScriptThatFailsKeepsWhatWasRecorded) {
  const sim::Script script = ScriptOf(
      "{\"do\":\"wait\",\"seconds\":0.5}\n{\"hand\":\"left\",\"do\":\"grasp\",\"object\":\"z\"}\n");
  std::string message;
  EXPECT_THROW(
      experiment::Run(
          {.scene = Pair(), .script = script, .record = root_ / "demo", .has_pictures = false},
          {.on_message = [&](std::string_view text) { message = text; }}),
      InputError);
  EXPECT_EQ(message, "recorded in " + (root_ / "demo").string());
  EXPECT_EQ(TicksOf(recording::OpenRecording(root_ / "demo")).last, 30u);
}

TEST_F(RunTest, ACancelledRunIsAShorterOne) {
  const RunPlan plan{
      .scene = Pair(), .seconds = 10, .record = root_ / "demo", .has_pictures = false};
  const RunResult cancelled = experiment::Run(plan, CancelledAtPoll(13));
  EXPECT_EQ(cancelled.ticks, 12u);
  EXPECT_EQ(TicksOf(recording::OpenRecording(root_ / "demo")).last, 12u);
  EXPECT_EQ(experiment::Run({.scene = Pair(), .seconds = 0.2}).state_hash, cancelled.state_hash);
}

TEST_F(RunTest, ContinuesARecordingAtTheGivenStep) {
  const fs::path demo = root_ / "demo";
  experiment::Run({.scene = Pair(), .seconds = 0.5, .record = demo, .has_pictures = false});
  const recording::Recording recording = recording::OpenRecording(demo);
  const RunResult continued =
      experiment::Run({.scene = recording.scene(),
                       .seconds = 0.25,
                       .continuation = RunPlan::Continuation{demo, {.tick = 30}},
                       .has_pictures = false});
  EXPECT_EQ(continued.ticks, 45u);
  EXPECT_EQ(TicksOf(recording::OpenRecording(demo)).last, 45u);
  EXPECT_EQ(experiment::Run({.scene = Pair(), .seconds = 0.75}).state_hash, continued.state_hash);
}

TEST_F(RunTest, ItsJsonHasTheDocumentedFields) {
  const Json json = ToJson(experiment::Run({.scene = Pair(), .seconds = 0}));
  for (const char* field : {"ticks", "seconds", "hash", "realtime_factor", "objects", "controls",
                            "robot", "brain", "recordings"}) {
    EXPECT_TRUE(json.contains(field)) << field;
  }
  EXPECT_EQ(json["brain"], (Json{{"status", "none"}, {"message", ""}, {"claim", nullptr}}));
  EXPECT_TRUE(json["robot"].is_null());
  EXPECT_FALSE(json.contains("late_ticks"));
}

}  // namespace
}  // namespace smile::experiment
