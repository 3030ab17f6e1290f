#pragma once

#include <map>
#include <utility>

#include "base/demand.h"
#include "sim/action_history.h"

namespace smile::sim {

/// What a listener remembers of actions, by their ids. Only the history knows which of them are
/// done, so an undo or redo changes nothing here.
template <class Mark>
class ActionMarks {
 public:
  /// Marks the current action, which has just begun, and forgets the actions it has discarded.
  void Begin(const ActionHistory& history, Mark mark) {
    const auto done = history.done();
    SMILE_DEMAND(done.size() > 1);
    // Ids ascend along the history: whatever is above the previous action was discarded.
    marks_.erase(marks_.upper_bound(done[done.size() - 2].id), marks_.end());
    marks_.emplace(done.back().id, std::move(mark));
  }
  /// The mark of an action, a new one if it has none.
  Mark& operator[](ActionId action) { return marks_[action]; }

  /// nullptr if the action has no mark.
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
