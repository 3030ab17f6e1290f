#include "task/imitation_result.h"
#include "task/demonstrated_structure.h"

#include "base/diagnostic.h"
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

Json NeighborsJson(const std::vector<NeighborError>& neighbors) {
  Json json = Json::array();
  for (const NeighborError& error : neighbors) {
    json.push_back({{"object", error.pair.object},
                    {"other", error.pair.other},
                    {"mm", 1000 * error.distance},
                    {"degrees", RadiansToDegrees(error.angle)},
                    {"kept", error.is_within()}});
  }
  return json;
}

/// Returns the part of the way from the score at the start to 1; null if nothing was to be done.
Json GainJson(double score, double score_at_start) {
  if (score_at_start >= 1) return nullptr;
  return (score - score_at_start) / (1 - score_at_start);
}

/// Returns whether what a program claims is true; null if it claims nothing.
Json IsClaimRight(const Json& brain, bool is_success) {
  const auto claim = brain.find("claim");
  if (claim == brain.end() || claim->is_null()) return nullptr;
  return claim->at("done").get<bool>() == is_success;
}

Json ToJson(const Order& order) {
  return {{"kept", order.is_kept()},
          {"share", order.fraction},
          {"demonstrated", order.demonstrated},
          {"done", order.done}};
}

Json BrokenRulesJson(const std::vector<RuleBreak>& breaks) {
  Json json = Json::array();
  for (const RuleBreak& one : breaks) {
    json.push_back({{"rule", one.rule == RuleBreak::Rule::kOrder ? "order" : "support"},
                    {"object", one.object},
                    {"other", one.other},
                    {"seconds", one.seconds}});
  }
  return json;
}

Json EffectsJson(const Structure& structure, const std::vector<bool>& achieved, double unit) {
  Json json = Json::array();
  for (std::size_t i = 0; i < structure.effects.size(); ++i) {
    json.push_back(ToJson(structure.effects[i], unit));
    json.back()["text"] = WordsOf(structure.effects[i], unit);
    json.back()["achieved"] = static_cast<bool>(achieved[i]);
  }
  return json;
}

Json ToJson(const Work& work) { return {{"grasps", work.grasps}, {"retries", work.retries}}; }

/// Returns the episode of a scene in which nothing has happened yet.
Episode EpisodeBefore(const scene::SceneSpec& scene) {
  const recording::TraceTick start = recording::StartOf(model::Model(scene));
  return {.scene = scene, .begin = start, .end = start, .contacts = {}};
}

ProgramEnd EndOf(const Json& brain) {
  return {.status = brain.value("status", ""), .message = brain.value("message", "")};
}

}  // namespace

void RequireSomethingToDo(const Structure& structure, const scene::SceneSpec& scene) {
  // Matching throws if an object has no counterpart. Its result is discarded: the final match
  // depends on the outcome, see CompareWith().
  (void)MatchObjects(structure, scene);
  if (CompareWith(structure, EpisodeBefore(scene)).is_achieved()) {
    throw InputError({scene.name, 0, "",
                      "is already as the demonstration left it, expected a scene in which there is "
                      "something to do"});
  }
}

ImitationTask MakeImitationTask(std::string name, const recording::Recording& demonstration,
                                scene::SceneSpec scene) {
  ImitationTask task{
      .name = std::move(name), .structure = StructureOf(demonstration), .scene = std::move(scene)};
  RequireSomethingToDo(task.structure, task.scene);
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
  const bool is_success = IsSuccess(comparison, program);
  const double score_at_start = CompareWith(structure, AtBegin(outcome)).score;
  Json result = {{"format", kResultFormat},
                 {"task", task.name},
                 {"success", is_success},
                 {"score", comparison.score},
                 {"score_at_start", score_at_start},
                 {"gain", GainJson(comparison.score, score_at_start)},
                 {"claim_right", IsClaimRight(run_info.brain, is_success)},
                 {"tolerance", kTolerance / unit},
                 {"match", comparison.match},
                 {"goal", {{"objects", PosesJson(comparison.goal, unit)}}},
                 {"initial", {{"objects", PosesJson(StartOf(task.scene), unit)}}},
                 {"final", {{"objects", PosesJson(PosesAt(outcome.scene, outcome.end), unit)}}},
                 {"errors", ErrorsJson(comparison.errors)},
                 {"neighbors", NeighborsJson(comparison.neighbors)},
                 {"intruders", comparison.intruders},
                 {"mean_error_mm", MillimetersOf(mean)},
                 {"mean_error_degrees", DegreesOf(mean)},
                 {"order", ToJson(comparison.order)},
                 {"broken_rules", BrokenRulesJson(comparison.broken_rules)},
                 {"effects", EffectsJson(structure, comparison.achieved, unit)},
                 {"work", ToJson(WorkOf(outcome))},
                 {"cause", ToJson(FailureReasonOf(structure, outcome, comparison, program))},
                 {"seconds", run_info.seconds},
                 {"realtime_factor", run_info.realtime_factor},
                 {"brain", run_info.brain}};
  // Absent where something determines the place of the structure.
  if (comparison.turn) {
    result["turned_degrees"] = RadiansToDegrees(*comparison.turn);
    result["mirrored"] = comparison.is_mirrored;
  }
  // Absent for programs that get the demonstration as a whole and do not watch it.
  if (run_info.watched_seconds > 0) {
    result["watched_seconds"] = run_info.watched_seconds;
  }
  return result;
}

std::optional<ClaimEnd> ReadClaim(const JsonNode& result) {
  constexpr std::size_t kMaxReasonBytes = 4096;
  if (!result.Has("claim_right") || result.Member("claim_right").IsNull()) return std::nullopt;
  const JsonNode claim = result.Member("brain").Member("claim");
  return ClaimEnd{.is_done = claim.Member("done").Flag(),
                  .is_right = result.Member("claim_right").Flag(),
                  .reason = claim.Member("reason").ShortString(kMaxReasonBytes)};
}

bool ReadSuccess(const JsonNode& result) {
  // Format 1 has no field `format`.
  if (result.Has("rebuilt") && !result.Has("format")) return result.Member("rebuilt").Flag();
  result.Member("format").Number(kResultFormat, kResultFormat);
  return result.Member("success").Flag();
}

}  // namespace smile::task
