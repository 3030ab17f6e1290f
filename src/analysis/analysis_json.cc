#include "analysis/analysis_json.h"

#include "base/version.h"
#include "sim/tick.h"

namespace smile::analysis {
namespace {

using Rendering = Json (*)(const texts::UserMessage& message);

/// Returns null without a message.
Json OrNull(const std::optional<texts::UserMessage>& message, Rendering rendered) {
  return message ? rendered(*message) : Json(nullptr);
}

Json PartsOf(const Subtask& subtask) {
  Json parts = Json::array();
  for (const sim::ActionSummary& part : subtask.parts) parts.push_back(ToJson(std::optional(part)));
  return parts;
}

/// People count subtasks from 1.
std::size_t NumberOf(std::size_t index) { return index + 1; }

}  // namespace

Json ToJson(const Analysis& analysis, Rendering rendered) {
  const std::vector<std::size_t> levels = analysis.Levels();
  Json subtasks = Json::array();
  for (std::size_t i = 0; i < analysis.subtasks.size(); ++i) {
    const SubtaskFinding& finding = analysis.subtasks[i];
    const Subtask& subtask = finding.subtask;
    subtasks.push_back({{"number", NumberOf(i)},
                        {"segments", {subtask.first, subtask.last}},
                        {"seconds", {sim::SecondsOf(subtask.begin), sim::SecondsOf(subtask.end)}},
                        {"words", subtask.words},
                        {"parts", PartsOf(subtask)},
                        {"actions", subtask.actions},
                        {"objects", subtask.objects},
                        {"necessary", finding.harm.has_value()},
                        {"without", OrNull(finding.harm, rendered)},
                        {"level", levels[i]}});
  }
  Json order = Json::array();
  for (const Precedence& one : analysis.precedences) {
    order.push_back({{"before", NumberOf(one.before)},
                     {"after", NumberOf(one.after)},
                     {"otherwise", rendered(one.harm)}});
  }
  Json sufficient = Json::array();
  for (const std::size_t subtask : analysis.sufficient) sufficient.push_back(NumberOf(subtask));
  Json properties = Json::array();
  for (const PropertyFinding& one : analysis.properties) {
    const bool is_color = one.property == PropertyFinding::Property::kColor;
    properties.push_back({{"property", is_color ? "color" : "place"},
                          {"object", one.object.empty() ? Json(nullptr) : Json(one.object)},
                          {"tried", one.tried.empty() ? Json(nullptr) : rendered(one.tried)},
                          {"harm", OrNull(one.harm, rendered)}});
  }
  Json goals = Json::array();
  for (const GoalFinding& one : analysis.goals) {
    goals.push_back({{"id", one.goal.id},
                     {"words", rendered(one.goal.words)},
                     {"kind", one.goal.is_place ? "place" : "effect"},
                     {"counts", one.counts}});
  }
  return {{"format", kAnalysisFormat},
          {"program", ProgramName()},
          {"demonstration", analysis.demonstration},
          {"goals", std::move(goals)},
          {"subtasks", std::move(subtasks)},
          {"order", std::move(order)},
          {"sufficient", std::move(sufficient)},
          {"properties", std::move(properties)},
          {"why_not_moved",
           analysis.why_not_moved.empty() ? Json(nullptr) : rendered(analysis.why_not_moved)},
          {"simulations", analysis.num_simulations}};
}

}  // namespace smile::analysis
