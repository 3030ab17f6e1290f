#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/strong_id.h"
#include "sim/action_summary.h"
#include "sim/command.h"
#include "sim/event.h"
#include "sim/simulation_state.h"

namespace smile::sim {

/// Identifier of an action of one simulation. Ids count up from 1 in the order in which actions
/// began and are never used twice. Id 0 is the start, before the first action.
using ActionId = StrongId<struct ActionTag>;

/// A command and the tick at which it was applied.
struct TimedCommand {
  std::uint64_t tick = 0;  ///< at which it was applied
  Command command;

  bool operator==(const TimedCommand&) const = default;
};

/// An action with everything that followed it, up to the next action.
struct Action {
  ActionId id;
  std::uint64_t tick = 0;                ///< at which it began
  std::optional<ActionSummary> summary;  ///< nullopt for the start
  std::vector<TimedCommand> commands;  ///< in order; the first is the action itself, see IsAction()
  std::vector<Event> events;           ///< in order; refusals are left out

  /// State before the action; nullptr for the start, and after it was discarded for space.
  std::unique_ptr<const SimulationState> before;
  std::size_t num_bytes_before = 0;  ///< of `before`, without what it shares with the last action's
  /// State at the undo; nullptr while the action is done.
  std::unique_ptr<const SimulationState> at_undo;
  /// number of events of the previous action when this one began
  std::size_t num_events_before = 0;
};

/// History of a simulation: a list of actions and a cursor.
///
///     start | a1 | a2 | a3 | a4          a1 and a2 are done, a3 and a4 are undone:
///                     ^ cursor           Undo() takes back a2, Redo() does a3 again
///
/// A command after an undo discards the undone actions. Each action keeps the state before it:
/// a few bytes per object, and 2 kB more for each object to which something happened since the last
/// action. Beyond half a gigabyte the oldest states are discarded, so Undo() no longer reaches
/// them; the actions themselves stay.
///
/// There is no other copy of the history: listeners keep only values per ActionId and are notified
/// when the cursor moves; see Listener::OnMove() and PerAction.
class ActionHistory {
 public:
  explicit ActionHistory(std::size_t max_state_bytes = std::size_t{512} << 20);

  /// Returns the start and the actions that are done, in order.
  std::span<const Action> done() const { return {actions_.data(), cursor_ + 1}; }
  /// Returns the undone actions, in order.
  std::span<const Action> undone() const { return std::span(actions_).subspan(cursor_ + 1); }
  /// Returns the last action that is done, or the start.
  const Action& current() const { return actions_[cursor_]; }
  bool can_undo() const { return current().before != nullptr; }
  bool can_redo() const { return !undone().empty(); }

  /// Returns true if the history reaches back to the start of the scene: done() then contains all
  /// actions that led from there to the present state.
  bool is_complete() const { return is_complete_ || LastLoad() > 0; }
  /// Returns all commands that were done in the present scene, in order.
  std::vector<TimedCommand> CommandsDone() const;

  // The members below are for the simulation that owns the history.

  /// Begins an action that was applied to the simulation in state `before`.
  void Begin(SimulationState before);
  /// Add to the current action.
  void Add(TimedCommand command);
  void Add(Event event);
  void Describe(ActionSummary summary) { actions_[cursor_].summary = std::move(summary); }
  /// Moves the cursor back by one action. Requires can_undo().
  /// @param now  the present state, which Redo() will return.
  /// @returns the state before the action, valid until the next change of the history.
  const SimulationState& Undo(SimulationState now);
  /// Moves the cursor forward by one action. Requires can_redo().
  /// @returns the state at the undo of the action.
  std::unique_ptr<const SimulationState> Redo();
  /// Restarts the history at `tick` of a state that was restored from elsewhere: nothing can be
  /// undone, and the history is no longer complete.
  void Restart(std::uint64_t tick);

 private:
  /// Returns the index of the last done action that loaded a scene; 0, the start, if none did.
  std::size_t LastLoad() const;
  void CountState(std::size_t index);
  void DiscardUndone();
  void DropOldestStates();

  std::size_t max_state_bytes_;
  std::vector<Action> actions_;  ///< the first one is the start
  std::size_t cursor_ = 0;       ///< index of the current action
  std::uint32_t last_id_ = 0;
  std::size_t num_state_bytes_ = 0;  ///< of all states before actions
  std::size_t first_state_ = 1;      ///< index of the first action whose state is kept
  bool is_complete_ = true;
};

}  // namespace smile::sim
