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
  /// Notes what is there before a tick. `running` must outlive this.
  explicit ChangeDetector(const RunningModel* running);
  /// Notes what is there before a command, as far as the command may change it.
  ChangeDetector(const RunningModel* running, const Command& command);

  /// The events of the command, which has been carried out: its own, then those of bonds, controls
  /// and grippers that followed from it.
  std::vector<Event> EventsOf(const Command& command) const;
  /// The events of the tick, which is over: what grippers got hold of or let go.
  std::vector<Event> EventsOfTick() const;

 private:
  void AppendOwn(const Command& command, std::vector<Event>* events) const;
  /// A bond that ended because an object was destroyed is no hand's.
  void AppendBonds(const Command& command, std::vector<Event>* events) const;
  void AppendControls(std::vector<Event>* events) const;
  void AppendGrippers(std::vector<Event>* events) const;
  /// Ids of the objects that came or went.
  std::vector<std::string> ChangedObjects() const;

  const RunningModel& running_;
  std::vector<std::vector<physics::BodyId>> held_by_grippers_;
  std::string held_by_hand_;         ///< id of what the command's hand held
  std::vector<bool> were_present_;   ///< of each object, where the command may change that
  world::TabletopState mechanisms_;  ///< where the command may change them
};

}  // namespace smile::sim
