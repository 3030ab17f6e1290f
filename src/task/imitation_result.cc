#include "task/imitation_result.h"

#include "math/angles.h"
#include "scene/units.h"
#include "task/score.h"

namespace smile::task {
namespace {

Json DescribePoses(const ObjectPoses& poses, double meters_per_unit) {
  Json json = Json::object();
  for (const auto& [id, X_WB] : poses) {
    const Vector3 p = scene::ToFileUnits(X_WB.translation(), meters_per_unit);
    const Vector3 angles = FixedAxesAngles(X_WB.rotation());
    json[id] = {{"position", {p.x(), p.y(), p.z()}},
                {"rotation", {angles.x(), angles.y(), angles.z()}}};
  }
  return json;
}

}  // namespace

ObjectPoses StartOf(const scene::SceneSpec& scene) {
  ObjectPoses poses;
  for (const scene::ObjectSpec& object : scene.objects) {
    poses[object.id()] = object.pose_in_world();
  }
  return poses;
}

Json ResultOf(const Exercise& exercise, const ObjectPoses& final_poses) {
  const Score score = ScoreOutcome(exercise.goal, exercise.match, final_poses);
  const double unit = exercise.scene.meters_per_unit;
  return {{"task", exercise.name},
          {"rebuilt", score.is_rebuilt()},
          {"score", score.share},
          {"tolerance", kTolerance / unit},
          {"match", exercise.match},
          {"goal", {{"objects", DescribePoses(score.goal, unit)}}},
          {"initial", {{"objects", DescribePoses(StartOf(exercise.scene), unit)}}},
          {"final", {{"objects", DescribePoses(final_poses, unit)}}},
          {"mean_error_mm", score.mean_error * 1000}};
}

}  // namespace smile::task
