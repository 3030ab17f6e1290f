#include "experiment/task_experiment.h"

#include "experiment_fixture.h"
#include "recording/recording.h"

namespace smile::experiment {
namespace {

using TaskExperiment = ExperimentTest;

TEST_F(TaskExperiment, ShippedTasksHaveTheirFiles) {
  for (const std::string_view task : kTasks) {
    const std::string name(task);
    EXPECT_NO_THROW(DataFile("scenes/" + name + ".xml"));
    EXPECT_NO_THROW(DataFile("scenes/" + name + "_robot.xml"));
    EXPECT_NO_THROW(DataFile("examples/" + name + ".jsonl"));
  }
}

TEST_F(TaskExperiment, CancelledInTheDemonstrationKeepsItAndTheEarlierResults) {
  Write("out/result.json", "{}");
  bool has_begun = false;
  const Callbacks callbacks{
      .is_cancelled = [&] { return has_begun; },
      .on_progress = [&](const std::string& step, double done,
                         double) { has_begun = step == "showing row" && done > 0.2; }};
  EXPECT_THROW(
      RunTaskExperiment({.task = "row", .out = root_ / "out", .robot = Baxter()}, callbacks),
      std::runtime_error);
  EXPECT_TRUE(recording::IsRecording(root_ / "out/demonstration"));
  EXPECT_FALSE(Exists("out/imitation"));
  EXPECT_TRUE(Exists("out.1/result.json"));
}

}  // namespace
}  // namespace smile::experiment
