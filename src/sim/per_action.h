#pragma once

#include <map>
#include <utility>

#include "base/demand.h"
#include "sim/action_history.h"

namespace smile::sim {

/// Values that a listener keeps per action id. Only the history knows which actions are done, so an
/// undo or redo changes nothing here.
template <class Value>
class PerAction {
 public:
  /// Sets the value of the current action, which has just begun, and removes the values of the
  /// actions that it discarded.
  void Begin(const ActionHistory& history, Value value) {
    const auto done = history.done();
    SMILE_DEMAND(done.size() > 1);
    // Ids ascend along the history: values above the previous action belong to discarded ones.
    values_.erase(values_.upper_bound(done[done.size() - 2].id), values_.end());
    values_.emplace(done.back().id, std::move(value));
  }
  /// Returns the value of an action, a new one if it has none.
  Value& operator[](ActionId action) { return values_[action]; }

  /// Returns the value of an action, or nullptr.
  Value* Find(ActionId action) {
    const auto found = values_.find(action);
    return found != values_.end() ? &found->second : nullptr;
  }
  const Value* Find(ActionId action) const {
    const auto found = values_.find(action);
    return found != values_.end() ? &found->second : nullptr;
  }
  std::size_t size() const { return values_.size(); }

 private:
  std::map<ActionId, Value> values_;
};

}  // namespace smile::sim
