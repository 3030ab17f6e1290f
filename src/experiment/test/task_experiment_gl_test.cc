#include "experiment/task_experiment.h"

#include "experiment/robot_region.h"
#include "experiment_fixture.h"
#include "recording/recording.h"
#include "task/imitation_result.h"

namespace smile::experiment {
namespace {

using TaskExperiment = ExperimentTest;

TEST_F(TaskExperiment, ShippedTasksHaveTheirFiles) {
  for (const ShippedTask& task : kTasks) {
    const std::string name(task.name);
    EXPECT_NO_THROW(DataFile("scenes/" + name + ".xml"));
    EXPECT_NO_THROW(DataFile("scenes/" + name + "_robot.xml"));
    EXPECT_NO_THROW(DataFile("examples/" + name + ".jsonl"));
  }
}

// A program that does nothing earns nothing, in the shipped layout and in others: no layout does
// the task, and none puts anything where the robot stands at the start, as once at seed 1003 of
// unstack.
TEST_F(TaskExperiment, AnIdleProgramGainsNothingInAnyShippedTask) {
  for (const ShippedTask& shipped : kTasks) {
    const std::string name(shipped.name);
    const fs::path demonstration = root_ / name;
    RunPlan plan{.scene = scene_xml::LoadScene(DataFile("scenes/" + name + ".xml")),
                 .record = demonstration,
                 .has_pictures = false};
    if (name == "tower") plan.robot = Baxter();  // its script hides the robot
    plan.script = sim::ReadScript(DataFile("examples/" + name + ".jsonl"), 0.1);
    (void)experiment::Run(plan);
    const recording::Recording recording = recording::OpenRecording(demonstration);
    const scene::SceneSpec scene = scene_xml::LoadScene(DataFile("scenes/" + name + "_robot.xml"));
    for (const auto& seed : std::vector<std::optional<std::uint64_t>>{std::nullopt, 2, 1003}) {
      const layout::LayoutChoice choice{.seed = seed, .level = shipped.level};
      const task::ImitationTask task = task::MakeImitationTask(
          name, recording,
          layout::LaidOut(scene, choice, [](double height) { return RegionOf(Baxter(), height); }));
      if (seed) {
        EXPECT_NE(task.scene.objects, scene.objects) << name << ", seed " << *seed;
      }
      sim::Simulation simulation(task.scene, Baxter());
      const task::EpisodeObserver observer(&simulation);
      while (simulation.seconds() < 3) simulation.Tick();
      const Json result =
          task::ResultOf(task, observer.episode(),
                         {.brain = {{"status", "exited"}, {"message", ""}, {"claim", nullptr}}});
      EXPECT_EQ(result["gain"], 0) << name;
      EXPECT_EQ(result["success"], false) << name;
    }
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
