#include "experiment/imitation.h"

#include <algorithm>
#include <utility>

#include "base/hash_text.h"
#include "experiment/plan_file.h"
#include "experiment/run.h"
#include "replay/replay.h"

namespace smile::experiment {
namespace {

/// Returns the run of an imitation.
RunPlan RunPlanOf(const ImitationPlan& plan, const task::Structure& goal) {
  scene::SceneSpec scene = plan.scene;
  Apply(plan.looks, &scene);
  return {.scene = std::move(scene),
          .robot = plan.robot,
          .brain = plan.brain,
          .brain_function = plan.brain_function,
          .callback_seconds = plan.callback_seconds,
          .is_attached = plan.is_attached,
          .demonstration = plan.demonstration,
          .max_seconds = plan.max_seconds,
          .seconds_after_brain = plan.hold_seconds,
          .record = plan.record,
          .recording = {.title = plan.task + ", imitated"},
          .has_pictures = plan.has_pictures,
          .eye = plan.eye,
          .noise = plan.noise,
          .behavior = plan.behavior,
          .gives_poses = plan.gives_poses,
          .disturbance = plan.disturbance,
          .label = "the robot builds",
          // Objects of other colors do not look like those of the goal.
          .goal = plan.looks.colors.empty() ? &goal : nullptr};
}

/// Gives the objects the colors of another scene, which has the same ones first.
void RestoreColors(const scene::SceneSpec& before, scene::SceneSpec* scene) {
  const std::size_t count = std::min(before.objects.size(), scene->objects.size());
  for (std::size_t i = 0; i < count; ++i) {
    scene->objects[i].whole.color = before.objects[i].whole.color;
    scene->objects[i].whole.shape = before.objects[i].whole.shape;
  }
}

/// Replays the recording of an imitation and adds `replay` to its result. One that differs is no
/// success.
void AddReplay(const std::filesystem::path& record, const Callbacks& callbacks, Json* result) {
  const replay::ReplayReport report =
      replay::Replay(recording::OpenRecording(record), {.stops_at_difference = true},
                     callbacks.ProgressOf("verifying the recording"));
  const auto& difference = report.first_difference;
  (*result)["replay"] = {
      {"identical", !difference}, {"ticks", report.ticks()}, {"hash", HashText(report.hash)}};
  if (!difference) return;
  (*result)["success"] = false;
  (*result)["cause"] = task::ToJson(task::FailureReason{
      "replay_differs",
      texts::Say("failures.replayDiffers", {{"tick", difference->tick},
                                            {"object", difference->object},
                                            {"quantity", difference->quantity}})});
}

}  // namespace

ImitationResult Imitate(const ImitationPlan& plan, const Callbacks& callbacks) {
  // Made before the run, so that an impossible task fails at once.
  const recording::Recording demonstration = recording::OpenRecording(plan.demonstration);
  const task::ImitationTask imitation_task =
      task::MakeImitationTask(plan.task, demonstration, plan.scene);
  RunPlan run_plan = RunPlanOf(plan, imitation_task.structure);
  if (!plan.analysis.empty()) run_plan.plan = ReadPlan(plan.analysis, demonstration);
  const RunResult run = Run(run_plan, callbacks);
  // Scored from the recording, so that anyone can repeat the score. The recording is also what
  // people check a score against; state that only lived in memory would escape them.
  task::Episode outcome = task::EpisodeOf(recording::OpenRecording(plan.record));
  if (!plan.looks.colors.empty()) RestoreColors(plan.scene, &outcome.scene);
  Json result =
      task::ResultOf(imitation_task, outcome,
                     // Watching takes as long as the demonstration, and the rest
                     // belongs to the score; what counts is the time of acting.
                     {.seconds = run.seconds - run.watched_seconds - run.seconds_after_brain,
                      .watched_seconds = run.watched_seconds,
                      .realtime_factor = run.realtime_factor,
                      .brain = BrainJson(run)});
  if (plan.disturbance) result["disturbance"] = run.disturbance;
  if (plan.is_verified && !callbacks.IsCancelled()) AddReplay(plan.record, callbacks, &result);
  const bool has_succeeded = result["success"].get<bool>();
  return {
      .json = std::move(result), .has_succeeded = has_succeeded, .brain_error = run.brain_error};
}

}  // namespace smile::experiment
