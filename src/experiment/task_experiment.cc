#include "experiment/task_experiment.h"

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "analysis/analysis.h"
#include "analysis/analysis_json.h"
#include "base/files.h"
#include "experiment/move_aside.h"
#include "experiment/robot_region.h"
#include "experiment/run.h"
#include "picture/film.h"
#include "report/experiment_page.h"
#include "scene_xml/scene_reader.h"

namespace smile::experiment {
namespace {

/// The brain that imitates unless another one is given.
constexpr const char* kLearner = "matlab/learner";

/// Timeout per callback: a busy machine is no reason to fail [s].
constexpr double kPatientCallbackSeconds = 60;

/// Films the demonstration and the imitation, from the usual view for people. Small and at a low
/// rate: without a graphics card, films take longer than the experiment itself.
void FilmBoth(const std::filesystem::path& out, const Callbacks& callbacks) {
  for (const char* name : {"demonstration", "imitation"}) {
    if (callbacks.IsCancelled()) return;
    picture::Film(recording::OpenRecording(out / name), (out / name).string() + ".mp4",
                  {.request = {.width_px = 640, .height_px = 360},
                   .frames_per_second = 15,
                   .speed = kFilmSpeed},
                  callbacks.ProgressOf(std::string("filming the ") + name));
  }
}

/// Writes the page with pictures, numbers, and links to the other files.
void WriteReport(const TaskExperimentPlan& plan, const Json& result, const Callbacks& callbacks) {
  if (callbacks.IsCancelled()) return;
  std::vector<report::Enclosure> enclosures;
  if (plan.has_films) {
    enclosures.push_back({"demonstration.mp4", "film of the demonstration"});
    enclosures.push_back({"imitation.mp4", "film of the robot"});
  }
  enclosures.push_back({"demonstration", "recording of the demonstration"});
  enclosures.push_back({"imitation", "recording of the robot"});
  enclosures.push_back({"result.json", "result as data"});
  const recording::Recording demonstration = recording::OpenRecording(plan.out / "demonstration");
  const recording::Recording imitation = recording::OpenRecording(plan.out / "imitation");
  WriteFile(plan.out / "report.html", report::PageOf({.name = plan.task,
                                                      .demonstration = demonstration,
                                                      .imitation = imitation,
                                                      .result = result,
                                                      .enclosures = enclosures}));
}

/// Analyzes the demonstration and writes the result beside it.
/// @returns the file.
std::filesystem::path WriteAnalysis(const std::filesystem::path& out, const Callbacks& callbacks) {
  callbacks.Say("finding out what mattered in the demonstration");
  const analysis::Analysis analysis = analysis::Analyze(
      recording::OpenRecording(out / "demonstration"),
      // hardware_concurrency() may return 0 where it does not know.
      {.num_threads = std::max(1u, std::thread::hardware_concurrency()),
       .progress = [&](std::size_t, std::size_t) { return !callbacks.IsCancelled(); }});
  std::filesystem::path file = out / "analysis.json";
  WriteFile(file, ToText(ToJson(analysis), 2) + "\n");
  return file;
}

}  // namespace

const ShippedTask* FindTask(std::string_view name) {
  const auto task = std::ranges::find(kTasks, name, &ShippedTask::name);
  return task == kTasks.end() ? nullptr : &*task;
}

void RecordDemonstration(std::string_view task, const sim::RobotPlacement& robot,
                         const std::filesystem::path& directory, bool has_pictures,
                         const Callbacks& callbacks) {
  const std::string name(task);
  RunPlan run{.scene = scene_xml::LoadScene(DataFile("scenes/" + name + ".xml")),
              .robot = robot,
              .record = directory,
              .recording = {.title = name},
              .has_pictures = has_pictures,
              .label = "showing " + name};
  run.script = sim::ReadScript(DataFile("examples/" + name + ".jsonl"), run.scene.meters_per_unit);
  (void)Run(run, callbacks);
}

ImitationResult RunTaskExperiment(const TaskExperimentPlan& plan, const Callbacks& callbacks) {
  // Earlier results are never overwritten, so a failed experiment costs none.
  MoveAside(plan.out, callbacks);
  MakeDirectories(plan.out);
  RecordDemonstration(plan.task, plan.robot, plan.out / "demonstration", /*has_pictures=*/true,
                      callbacks);
  if (callbacks.IsCancelled())
    throw std::runtime_error("interrupted; the recording so far is kept");

  // Another table with the objects elsewhere: the robot must reproduce the structure, not the
  // motions.
  const scene::SceneSpec scene =
      layout::LaidOut(scene_xml::LoadScene(DataFile("scenes/" + plan.task + "_robot.xml")),
                      plan.layout, [&](double height) { return RegionOf(plan.robot, height); });
  const std::filesystem::path analysis =
      plan.is_analyzed ? WriteAnalysis(plan.out, callbacks) : std::filesystem::path();
  ImitationResult result = Imitate({.task = plan.task,
                                    .demonstration = plan.out / "demonstration",
                                    .analysis = analysis,
                                    .scene = scene,
                                    .brain = plan.brain.empty() ? DataFile(kLearner) : plan.brain,
                                    .callback_seconds = kPatientCallbackSeconds,
                                    .record = plan.out / "imitation",
                                    .robot = plan.robot},
                                   callbacks);
  // Before films and report, which take longer than the experiment and may be cancelled.
  WriteFile(plan.out / "result.json", ToText(result.json, 2) + "\n");
  if (plan.has_films) FilmBoth(plan.out, callbacks);
  WriteReport(plan, result.json, callbacks);
  return result;
}

}  // namespace smile::experiment
