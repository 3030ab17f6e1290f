#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/command.h"
#include "sim/event.h"
#include "sim/running_model.h"

namespace smile::sim {

/// Compares a running model before and after a command or a tick, and reports the differences as
/// events.
class ChangeDetector {
 public:
  /// Captures the state before a tick. `running` must outlive this.
  explicit ChangeDetector(const RunningModel* running);
  /// Captures the state before a command, as far as the command may change it.
  ChangeDetector(const RunningModel* running, const Command& command);

  /// Returns the events of the command, which has been applied: its own, then those of bonds,
  /// controls and grippers that followed.
  std::vector<Event> EventsOf(const Command& command) const;
  /// Returns the events of the tick, which is over: bodies that grippers grasped or released, then
  /// presses by contact, and the controls that they changed.
  std::vector<Event> EventsOfTick(const TickReport& report) const;

 private:
  void AppendOwn(const Command& command, std::vector<Event>* events) const;
  /// Bonds that ended because an object was destroyed have no hand.
  /// @param hand  that fastened or loosened; none if a tool did.
  void AppendBonds(const std::optional<HandName>& hand, std::vector<Event>* events) const;
  void AppendControls(std::vector<Event>* events) const;
  void AppendGrippers(std::vector<Event>* events) const;
  void AppendPress(const world::Press& press, std::vector<Event>* events) const;
  /// Returns the event of a use, without the hand.
  Event EventOf(const world::ToolUse& use) const;
  /// Returns the ids of the objects that were added or removed.
  std::vector<std::string> ChangedObjects() const;

  const RunningModel& running_;
  std::vector<std::vector<physics::BodyId>> held_by_grippers_;
  std::string held_by_hand_;         ///< id of the object that the command's hand held
  std::vector<bool> were_present_;   ///< per object, if the command may change that
  world::TabletopState mechanisms_;  ///< if the command may change them
};

}  // namespace smile::sim
