#include "task/imitation_result.h"

#include "math/angles.h"
#include "scene/units.h"
#include "task/comparison.h"
#include "task/failure_reason.h"
#include "task/structure_json.h"

namespace smile::task {
namespace {

constexpr int kResultFormat = 2;

/// Units of `result.json`: millimeters and degrees.
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
          {"share", order.fraction},
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

Json ToJson(const std::optional<FailureReason>& reason) {
  if (!reason) return nullptr;
  return {{"word", reason->code}, {"text", reason->text}};
}

ProgramEnd EndOf(const Json& brain) {
  return {.status = brain.value("status", ""), .message = brain.value("message", "")};
}

}  // namespace

ImitationTask MakeImitationTask(std::string name, const recording::Recording& demonstration,
                                scene::SceneSpec scene) {
  // Matching throws if an object has no counterpart. Its result is discarded: the final match
  // depends on the outcome, see CompareWith().
  ImitationTask task{
      .name = std::move(name), .structure = StructureOf(demonstration), .scene = std::move(scene)};
  (void)MatchObjects(task.structure, task.scene);
  return task;
}

Json ResultOf(const ImitationTask& task, const Episode& outcome, const RunInfo& run_info) {
  const Structure& structure = task.structure;
  // Poses and tolerance are in units of the scene file; errors are in millimeters and degrees
  // whatever the unit.
  const StructureComparison comparison = CompareWith(structure, outcome);
  const double unit = task.scene.meters_per_unit;
  const ObjectError mean = comparison.mean_error();
  const ProgramEnd program = EndOf(run_info.brain);
  Json result = {{"format", kResultFormat},
                 {"task", task.name},
                 {"success", IsSuccess(comparison, program)},
                 {"score", comparison.score},
                 {"tolerance", kTolerance / unit},
                 {"match", comparison.match},
                 {"goal", {{"objects", PosesJson(comparison.goal, unit)}}},
                 {"initial", {{"objects", PosesJson(StartOf(task.scene), unit)}}},
                 {"final", {{"objects", PosesJson(PosesAt(outcome.scene, outcome.end), unit)}}},
                 {"errors", ErrorsJson(comparison.errors)},
                 {"mean_error_mm", MillimetersOf(mean)},
                 {"mean_error_degrees", DegreesOf(mean)},
                 {"order", ToJson(comparison.order)},
                 {"effects", EffectsJson(structure, comparison.achieved, unit)},
                 {"work", ToJson(WorkOf(outcome))},
                 {"cause", ToJson(FailureReasonOf(structure, outcome, comparison, program))},
                 {"seconds", run_info.seconds},
                 {"realtime_factor", run_info.realtime_factor},
                 {"brain", run_info.brain}};
  // Absent for programs that get the demonstration as a whole and do not watch it.
  if (run_info.watched_seconds > 0) {
    result["watched_seconds"] = run_info.watched_seconds;
  }
  return result;
}

bool ReadSuccess(const JsonNode& result) {
  // Format 1 has no field `format`.
  if (result.Has("rebuilt") && !result.Has("format")) return result.Member("rebuilt").Flag();
  result.Member("format").Number(kResultFormat, kResultFormat);
  return result.Member("success").Flag();
}

}  // namespace smile::task
