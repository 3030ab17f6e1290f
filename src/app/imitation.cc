#include "app/imitation.h"

#include <utility>

#include "app/run_loop.h"
#include "record/attention.h"
#include "record/time_range.h"
#include "task/imitation_result.h"

namespace smile::app {
namespace {

task::ObjectPoses EndOf(const record::Recording& recording) {
  task::ObjectPoses poses = task::StartOf(recording.scene);
  const auto last = record::LastMoment(recording);
  for (std::size_t i = 0; last && i < recording.scene.objects.size(); ++i) {
    poses[recording.scene.objects[i].id()] = last->objects[i].pose_in_world();
  }
  return poses;
}

}  // namespace

ImitationOutcome Imitate(const ImitationPlan& plan) {
  const record::Recording demonstration = record::OpenRecording(plan.demonstration);
  task::Exercise exercise{
      .name = plan.task, .goal = task::GoalOf(demonstration), .match = {}, .scene = plan.scene};
  exercise.match = task::MatchObjects(exercise.goal, plan.scene);
  const RunOutcome run = Run({.scene = plan.scene,
                              .robot = plan.robot,
                              .brain = plan.brain,
                              .patience = plan.patience,
                              .is_attached = plan.is_attached,
                              .demonstration = plan.demonstration,
                              .attention = record::AttentionOf(demonstration),
                              .max_seconds = plan.max_seconds,
                              .record = plan.record,
                              .recording = {.title = plan.task + ", imitated"},
                              .has_pictures = plan.has_pictures,
                              .eye = plan.eye,
                              .noise = plan.noise,
                              .label = "the robot builds"});
  Json result = task::ResultOf(exercise, EndOf(record::OpenRecording(plan.record)));
  result["seconds"] = run.json["seconds"];
  result["realtime_factor"] = run.json["realtime_factor"];
  result["brain"] = run.json["brain"];
  const bool is_rebuilt = result["rebuilt"].get<bool>();
  return {.result = std::move(result), .is_rebuilt = is_rebuilt, .brain_error = run.brain_error};
}

}  // namespace smile::app
