#include "experiment/plan_file.h"

#include <algorithm>
#include <functional>

#include "analysis/analysis.h"
#include "analysis/analysis_json.h"
#include "base/json_node.h"
#include "experiment/json_file.h"

namespace smile::experiment {
namespace {

constexpr std::size_t kMaxSubtasks = 10'000, kMaxIds = 10'000, kMaxWordsBytes = 4096;
constexpr std::size_t kMaxPairs = 1'000'000, kMaxSegments = 1'000'000;

/// Returns the index of a subtask; people count from 1.
std::size_t IndexIn(const JsonNode& number, const brain::TaskPlan& plan) {
  return number.Whole(1, plan.subtasks.size()) - 1;
}

std::vector<std::string> IdsIn(const JsonNode& list) {
  std::vector<std::string> ids;
  for (const JsonNode& id : list.ItemsUpTo(kMaxIds)) ids.push_back(id.ShortString(kMaxWordsBytes));
  return ids;
}

brain::PlanSubtask SubtaskIn(const JsonNode& subtask) {
  const std::vector<JsonNode> segments = subtask.Member("segments").Items(2);
  const std::uint64_t first = segments[0].Whole(1, kMaxSegments);
  return {.words = subtask.Member("words").ShortString(kMaxWordsBytes),
          .objects = IdsIn(subtask.Member("objects")),
          .first = static_cast<int>(first),
          .last = static_cast<int>(segments[1].Whole(first, kMaxSegments)),
          .is_necessary = subtask.Member("necessary").Flag()};
}

/// Adds subtasks; their segments must follow each other, since brains find them by these.
void AddSubtasks(const JsonNode& list, brain::TaskPlan* plan) {
  for (const JsonNode& subtask : list.ItemsUpTo(kMaxSubtasks)) {
    plan->subtasks.push_back(SubtaskIn(subtask));
    const std::size_t count = plan->subtasks.size();
    if (count > 1 && plan->subtasks[count - 2].last >= plan->subtasks[count - 1].first) {
      subtask.Fail("begins before the subtask before it ends, expected the demonstrated order");
    }
  }
  if (plan->subtasks.empty()) list.Fail("is empty, expected at least one subtask");
}

void AddOrder(const JsonNode& list, brain::TaskPlan* plan) {
  for (const JsonNode& pair : list.ItemsUpTo(kMaxPairs)) {
    const std::size_t before = IndexIn(pair.Member("before"), *plan);
    const std::size_t after = IndexIn(pair.Member("after"), *plan);
    if (before >= after) pair.Fail("does not follow the demonstration, expected \"before\" first");
    plan->order.emplace_back(before, after);
  }
}

}  // namespace

brain::TaskPlan ReadPlan(const std::filesystem::path& file,
                         const recording::Recording& demonstration) {
  const Json json = ReadJsonFile(file);
  const std::string name = file.string();
  const JsonNode root(json, name, "");
  root.ExpectObject();
  // Other formats may mean something else by the same words.
  root.Member("format").Whole(analysis::kAnalysisFormat, analysis::kAnalysisFormat);
  const JsonNode content = root.Member("demonstration");
  if (content.String() != analysis::ContentOf(demonstration)) {
    content.Fail("is of another demonstration than " + demonstration.directory.string() +
                 ": run `smile analyze` for this one");
  }
  brain::TaskPlan plan;
  AddSubtasks(root.Member("subtasks"), &plan);
  AddOrder(root.Member("order"), &plan);
  for (const JsonNode& number : root.Member("sufficient").ItemsUpTo(plan.subtasks.size())) {
    plan.sufficient.push_back(IndexIn(number, plan));
  }
  if (std::ranges::adjacent_find(plan.sufficient, std::greater_equal()) != plan.sufficient.end()) {
    root.Member("sufficient").Fail("is not ascending");
  }
  for (const JsonNode& goal : root.Member("goals").ItemsUpTo(kMaxIds)) {
    const bool is_place = goal.Member("kind").String() == "place";
    if (is_place && goal.Member("counts").Flag()) {
      plan.goals.push_back(goal.Member("id").ShortString(kMaxWordsBytes));
    }
  }
  return plan;
}

}  // namespace smile::experiment
