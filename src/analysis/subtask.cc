#include "analysis/subtask.h"

#include <algorithm>
#include <set>

#include "base/diagnostic.h"
#include "recording/recording_history.h"

namespace smile::analysis {
namespace {

/// Hands that hold something, as the actions tell.
class HoldingHands {
 public:
  void Follow(const sim::ActionSummary& action) {
    if (!action.hand) return;
    switch (action.kind) {
      case sim::ActionKind::kTake:
        hands_.insert(*action.hand);
        break;
      case sim::ActionKind::kPut:
      case sim::ActionKind::kDrop:
      case sim::ActionKind::kRelease:
      case sim::ActionKind::kDestroy:
        // What both hands hold is released by both, however they took it.
        if (*action.hand == sim::HandName::kBoth) hands_.clear();
        hands_.erase(*action.hand);
        break;
      default:
        break;
    }
  }
  bool is_empty() const { return hands_.empty(); }

 private:
  std::set<sim::HandName> hands_;
};

/// Adds an id, unless it is empty or there already.
void AddObject(const std::string& id, std::vector<std::string>* objects) {
  if (!id.empty() && std::ranges::find(*objects, id) == objects->end()) objects->push_back(id);
}

/// Adds what an action is about; how many objects were cleared away or moved, or which scene was
/// loaded, is no id.
void AddObjects(const sim::ActionSummary& action, std::vector<std::string>* objects) {
  using enum sim::ActionKind;
  if (action.kind == kClear || action.kind == kMove || action.kind == kLoad) return;
  AddObject(action.what, objects);
  AddObject(action.with, objects);
}

/// Adds an action to what came of a subtask.
void AddPart(const recording::Segment& action, Subtask* subtask) {
  subtask->words += (subtask->words.empty() ? "" : ", ") + recording::WordsOf(action);
  if (action.summary) subtask->parts.push_back(*action.summary);
}

/// Adds an action to a subtask, which then ends with it.
/// @param start  tick at which the demonstration starts.
void Append(const recording::Segment& action, std::uint64_t start, Subtask* subtask) {
  const std::string words = recording::WordsOf(action);
  const bool takes = action.summary && action.summary->kind == sim::ActionKind::kTake;
  if (!takes) AddPart(action, subtask);
  subtask->actions.push_back(words);
  if (action.summary) AddObjects(*action.summary, &subtask->objects);
  subtask->last = subtask->first + static_cast<int>(subtask->actions.size()) - 1;
  subtask->end = action.end.tick - start;
}

}  // namespace

std::vector<Subtask> SubtasksOf(const recording::Recording& recording) {
  const std::vector<recording::Segment> path = OnPath(HistoryOf(recording));
  const std::uint64_t start = recording.info.start.tick;
  std::vector<Subtask> subtasks;
  HoldingHands hands;
  bool is_open = false;
  for (std::size_t number = 1; number < path.size(); ++number) {
    const recording::Segment& segment = path[number];
    if (!is_open) {
      subtasks.push_back({.first = static_cast<int>(number), .begin = segment.begin.tick - start});
    }
    Append(segment, start, &subtasks.back());
    if (segment.summary) hands.Follow(*segment.summary);
    is_open = !hands.is_empty();
  }
  if (subtasks.empty()) {
    throw InputError({recording.directory.string(), 0, "",
                      "contains no action of a hand, expected a demonstration by hands"});
  }
  // What is still held at the end.
  if (subtasks.back().words.empty()) AddPart(path.back(), &subtasks.back());
  return subtasks;
}

recording::Demonstration Arranged(const recording::Demonstration& demonstration,
                                  const std::vector<Subtask>& subtasks,
                                  const std::vector<std::size_t>& order) {
  recording::Demonstration arranged = demonstration;
  arranged.segments.clear();
  // Nothing was dropped from `demonstration`, so the number of a segment is its index.
  arranged.segments.push_back(demonstration.segments.front());
  for (const std::size_t subtask : order) {
    const auto first = demonstration.segments.begin();
    arranged.segments.insert(arranged.segments.end(), first + subtasks[subtask].first,
                             first + subtasks[subtask].last + 1);
  }
  return arranged;
}

}  // namespace smile::analysis
