#include "sim/action_history.h"

#include <algorithm>
#include <utility>

#include "base/demand.h"

// The list has the start at index 0, so the cursor always points to an action. Each action keeps
// the whole state before it: undo is a restoration, and no command needs an inverse. Memory is
// bounded by discarding the oldest of these states.

namespace smile::sim {
namespace {

/// Returns the approximate size of a state [bytes], without what it shares with the state before
/// it (or null): models, definitions, and the states of bodies to which nothing happened.
std::size_t SizeOf(const SimulationState& state, const SimulationState* before) {
  const auto& bodies = state.physics.bodies;
  const std::size_t num_entries =
      before == nullptr ? bodies.size() : bodies.NumBeside(before->physics.bodies);
  std::size_t size =
      sizeof state + state.physics.state.size() +
      sizeof(physics::Snapshot::BodyEntry) * num_entries +
      sizeof(world::ObjectStates::Numbered) * state.tabletop.objects.changed().size();
  const SharedList<physics::Snapshot::BodyEntry> none;
  for (const std::size_t i :
       bodies.MayDifferFrom(before == nullptr ? none : before->physics.bodies)) {
    // Bodies rarely come or go: those at the same place are the same.
    const bool is_shared = before != nullptr && i < before->physics.bodies.size() &&
                           bodies[i].state == before->physics.bodies[i].state;
    if (!is_shared) size += sizeof(std::vector<std::byte>) + bodies[i].state->size();
  }
  return size;
}

}  // namespace

ActionHistory::ActionHistory(std::size_t max_state_bytes)
    : max_state_bytes_(max_state_bytes), actions_(1) {}

std::vector<TimedCommand> ActionHistory::CommandsDone() const {
  std::vector<TimedCommand> commands;
  // A load begins another scene; what was done in the former one does not lead to the present
  // state.
  const std::size_t first = LastLoad();
  for (const Action& action : done().subspan(first)) {
    commands.insert(commands.end(), action.commands.begin(), action.commands.end());
  }
  // The load itself is not a command of the scene it loaded.
  if (first > 0) commands.erase(commands.begin());
  return commands;
}

std::size_t ActionHistory::LastLoad() const {
  std::size_t last = cursor_;
  const auto is_load = [](const Action& action) {
    return !action.commands.empty() && std::holds_alternative<Load>(action.commands[0].command);
  };
  while (last > 0 && !is_load(actions_[last])) --last;
  return last;
}

void ActionHistory::Begin(SimulationState before) {
  DiscardUndone();
  // Read before the state is moved from.
  const std::uint64_t tick = before.tick;
  const std::size_t num_events_before = current().events.size();
  actions_.push_back({.id = {++last_id_},
                      .tick = tick,
                      .summary = {},
                      .commands = {},
                      .events = {},
                      .before = std::make_unique<const SimulationState>(std::move(before)),
                      .num_bytes_before = 0,
                      .at_undo = nullptr,
                      .num_events_before = num_events_before});
  ++cursor_;
  CountState(cursor_);
  DropOldestStates();
}

/// Counts the state before an action, or counts it again.
void ActionHistory::CountState(std::size_t index) {
  Action& action = actions_[index];
  num_state_bytes_ -= action.num_bytes_before;
  action.num_bytes_before = SizeOf(*action.before, actions_[index - 1].before.get());
  num_state_bytes_ += action.num_bytes_before;
}

void ActionHistory::Add(TimedCommand command) {
  DiscardUndone();
  // A command that is no action belongs to the action before it, which it continues.
  actions_[cursor_].commands.push_back(std::move(command));
}

void ActionHistory::Add(Event event) { actions_[cursor_].events.push_back(std::move(event)); }

const SimulationState& ActionHistory::Undo(SimulationState now) {
  SMILE_DEMAND(can_undo());
  Action& undone = actions_[cursor_];
  // The action stays in the list, behind the cursor.
  undone.at_undo = std::make_unique<const SimulationState>(std::move(now));
  --cursor_;
  // Kept, as the action may be redone and undone again.
  return *undone.before;
}

std::unique_ptr<const SimulationState> ActionHistory::Redo() {
  SMILE_DEMAND(can_redo());
  Action& redone = actions_[cursor_ + 1];
  // Events since the undo are not on the path to the redone state.
  actions_[cursor_].events.resize(redone.num_events_before);
  ++cursor_;
  return std::move(redone.at_undo);
}

void ActionHistory::Restart(std::uint64_t tick) {
  actions_.clear();
  actions_.emplace_back().tick = tick;
  cursor_ = 0;
  num_state_bytes_ = 0;
  first_state_ = 1;
  // Ids continue to count: values of listeners must not match other actions.
  is_complete_ = false;
}

void ActionHistory::DiscardUndone() {
  // An undone action has its state before, as only such actions can be undone.
  for (const Action& action : undone()) num_state_bytes_ -= action.num_bytes_before;
  actions_.resize(cursor_ + 1);
}

void ActionHistory::DropOldestStates() {
  // The state of the current action always stays, so that one undo is possible.
  for (; num_state_bytes_ > max_state_bytes_ && first_state_ < cursor_; ++first_state_) {
    Action& oldest = actions_[first_state_];
    num_state_bytes_ -= oldest.num_bytes_before;
    oldest.num_bytes_before = 0;
    oldest.before.reset();
    // What the next state shared with it is now that state's alone.
    CountState(first_state_ + 1);
  }
}

}  // namespace smile::sim
