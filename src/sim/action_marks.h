#pragma once

#include <map>
#include <utility>

#include "base/demand.h"
#include "sim/action_history.h"

namespace smile::sim {

/// Values that a listener keeps per action id. Only the history knows which actions are done, so an
/// undo or redo changes nothing here.
template <class Mark>
class ActionMarks {
 public:
  /// Marks the current action, which has just begun, and drops the marks of the actions it
  /// discarded.
  void Begin(const ActionHistory& history, Mark mark) {
    const auto done = history.done();
    SMILE_DEMAND(done.size() > 1);
    // Ids ascend along the history: marks above the previous action belong to discarded ones.
    marks_.erase(marks_.upper_bound(done[done.size() - 2].id), marks_.end());
    marks_.emplace(done.back().id, std::move(mark));
  }
  /// Returns the mark of an action, a new one if it has none.
  Mark& operator[](ActionId action) { return marks_[action]; }

  /// Returns the mark of an action, or nullptr.
  Mark* Find(ActionId action) {
    const auto found = marks_.find(action);
    return found != marks_.end() ? &found->second : nullptr;
  }
  const Mark* Find(ActionId action) const {
    const auto found = marks_.find(action);
    return found != marks_.end() ? &found->second : nullptr;
  }
  std::size_t size() const { return marks_.size(); }

 private:
  std::map<ActionId, Mark> marks_;
};

}  // namespace smile::sim
