#include "task/imitation_result.h"

#include "math/angles.h"
#include "scene/units.h"
#include "task/cause.h"
#include "task/comparison.h"
#include "task/structure_json.h"

namespace smile::task {
namespace {

double MillimetersOf(const ObjectError& error) { return 1000 * error.distance; }
double DegreesOf(const ObjectError& error) { return RadiansToDegrees(error.angle); }

Json ErrorsJson(const std::map<std::string, ObjectError>& errors) {
  Json json = Json::object();
  for (const auto& [id, error] : errors) {
    json[id] = {{"mm", MillimetersOf(error)}, {"degrees", DegreesOf(error)}};
    if (error.is_held) json[id]["held"] = true;
  }
  return json;
}

Json ToJson(const Order& order) {
  return {{"kept", order.is_kept()},
          {"share", order.share},
          {"demonstrated", order.demonstrated},
          {"done", order.done}};
}

Json EffectsJson(const Structure& structure, const std::vector<bool>& achieved, double unit) {
  Json json = Json::array();
  for (std::size_t i = 0; i < structure.effects.size(); ++i) {
    json.push_back(ToJson(structure.effects[i], unit));
    json.back()["achieved"] = static_cast<bool>(achieved[i]);
  }
  return json;
}

Json ToJson(const Work& work) { return {{"grasps", work.grasps}, {"retries", work.retries}}; }

Json ToJson(const std::optional<Cause>& cause) {
  if (!cause) return nullptr;
  return {{"word", cause->word}, {"text", cause->text}};
}

ProgramEnd EndOf(const Json& brain) {
  return {.status = brain.value("status", ""), .message = brain.value("message", "")};
}

}  // namespace

Exercise MakeExercise(std::string name, const recording::Recording& demonstration,
                      scene::SceneSpec scene) {
  Exercise exercise{
      .name = std::move(name), .structure = StructureOf(demonstration), .scene = std::move(scene)};
  (void)MatchObjects(exercise.structure, exercise.scene);
  return exercise;
}

Json ResultOf(const Exercise& exercise, const Episode& outcome,
              const Circumstances& circumstances) {
  const Structure& structure = exercise.structure;
  const Comparison comparison = CompareWith(structure, outcome);
  const double unit = exercise.scene.meters_per_unit;
  const ObjectError mean = comparison.mean_error();
  const ProgramEnd program = EndOf(circumstances.brain);
  Json result = {{"task", exercise.name},
                 {"rebuilt", IsSuccess(comparison, program)},
                 {"score", comparison.share},
                 {"tolerance", kTolerance / unit},
                 {"match", comparison.match},
                 {"goal", {{"objects", PosesJson(comparison.goal, unit)}}},
                 {"initial", {{"objects", PosesJson(StartOf(exercise.scene), unit)}}},
                 {"final", {{"objects", PosesJson(PosesAt(outcome.scene, outcome.end), unit)}}},
                 {"errors", ErrorsJson(comparison.errors)},
                 {"mean_error_mm", MillimetersOf(mean)},
                 {"mean_error_degrees", DegreesOf(mean)},
                 {"order", ToJson(comparison.order)},
                 {"effects", EffectsJson(structure, comparison.achieved, unit)},
                 {"work", ToJson(WorkOf(outcome))},
                 {"cause", ToJson(CauseOf(structure, outcome, comparison, program))},
                 {"seconds", circumstances.seconds},
                 {"realtime_factor", circumstances.realtime_factor},
                 {"brain", circumstances.brain}};
  if (circumstances.watched_seconds > 0) {
    result["watched_seconds"] = circumstances.watched_seconds;
  }
  return result;
}

}  // namespace smile::task
