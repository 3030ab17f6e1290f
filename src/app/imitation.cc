#include "app/imitation.h"

#include <utility>

#include "app/run_loop.h"
#include "record/attention.h"
#include "task/imitation_result.h"

namespace smile::app {
ImitationOutcome Imitate(const ImitationPlan& plan) {
  const record::Recording demonstration = record::OpenRecording(plan.demonstration);
  const task::Exercise exercise = task::MakeExercise(plan.task, demonstration, plan.scene);
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
  const task::Course outcome = task::CourseOf(record::OpenRecording(plan.record));
  Json result = task::ResultOf(exercise, outcome,
                               {.seconds = run.json["seconds"].get<double>(),
                                .realtime_factor = run.json["realtime_factor"].get<double>(),
                                .brain = run.json["brain"]});
  const bool is_rebuilt = result["rebuilt"].get<bool>();
  return {.result = std::move(result), .is_rebuilt = is_rebuilt, .brain_error = run.brain_error};
}

}  // namespace smile::app
