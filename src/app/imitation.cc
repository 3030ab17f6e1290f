#include "app/imitation.h"

#include "app/run_loop.h"
#include "math/angles.h"
#include "record/attention.h"
#include "record/time_range.h"
#include "scene/units.h"
#include "task/goal.h"
#include "task/score.h"

namespace smile::app {
namespace {

Json DescribePoses(const task::ObjectPoses& poses, double meters_per_unit) {
  Json json = Json::object();
  for (const auto& [id, X_WB] : poses) {
    const Vector3 p = scene::ToFileUnits(X_WB.translation(), meters_per_unit);
    const Vector3 angles = FixedAxesAngles(X_WB.rotation());
    json[id] = {{"position", {p.x(), p.y(), p.z()}},
                {"rotation", {angles.x(), angles.y(), angles.z()}}};
  }
  return json;
}

task::ObjectPoses StartOf(const scene::SceneSpec& scene) {
  task::ObjectPoses poses;
  for (const scene::ObjectSpec& object : scene.objects) {
    poses[object.id()] = object.pose_in_world();
  }
  return poses;
}

task::ObjectPoses EndOf(const record::Recording& recording) {
  task::ObjectPoses poses = StartOf(recording.scene);
  const auto last = record::LastMoment(recording);
  for (std::size_t i = 0; last && i < recording.scene.objects.size(); ++i) {
    poses[recording.scene.objects[i].id()] = last->objects[i].pose_in_world();
  }
  return poses;
}

}  // namespace

ImitationOutcome Imitate(const ImitationPlan& plan) {
  const record::Recording demonstration = record::OpenRecording(plan.demonstration);
  const task::Goal goal = task::GoalOf(demonstration);
  const auto match = task::MatchObjects(goal, plan.scene);
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
                              .eye = plan.eye,
                              .noise = plan.noise,
                              .label = "the robot builds"});
  const task::ObjectPoses final_poses = EndOf(record::OpenRecording(plan.record));
  const task::Score score = task::ScoreOutcome(goal, match, final_poses);

  const double unit = plan.scene.meters_per_unit;
  ImitationOutcome outcome{.is_rebuilt = score.is_rebuilt(), .brain_error = run.brain_error};
  outcome.result = {{"task", plan.task},
                    {"rebuilt", score.is_rebuilt()},
                    {"score", score.share},
                    {"tolerance", task::kTolerance / unit},
                    {"match", match},
                    {"goal", {{"objects", DescribePoses(score.goal, unit)}}},
                    {"initial", {{"objects", DescribePoses(StartOf(plan.scene), unit)}}},
                    {"final", {{"objects", DescribePoses(final_poses, unit)}}},
                    {"mean_error_mm", score.mean_error * 1000},
                    {"seconds", run.json["seconds"]},
                    {"realtime_factor", run.json["realtime_factor"]},
                    {"brain", run.json["brain"]}};
  return outcome;
}

}  // namespace smile::app
