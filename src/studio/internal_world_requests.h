#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "page/request_fields.h"
#include "studio/internal_state_machine.h"
#include "studio/rehearsal.h"
#include "studio/resting_place.h"
#include "studio/snapping.h"

namespace smile::studio {

/// Requests that command the live world, query it, or control its time.
class WorldRequests {
 public:
  /// `states` must outlive this.
  explicit WorldRequests(StateMachine* states) : states_(states) {}

  Json Command(const page::RequestFields& fields);
  /// Tries the command on a copy of the world; see RequestRow::try_out.
  std::optional<texts::UserMessage> TryCommand(const page::RequestFields& fields);
  Json Spawn(const page::RequestFields& fields);
  Json Clear(const page::RequestFields& fields);
  std::optional<texts::UserMessage> RefuseClear(const page::RequestFields& fields) const;
  Json SetSnap(const page::RequestFields& fields);
  Json FindSupport(const page::RequestFields& fields);
  Json AnswerRestingPlace(const page::RequestFields& fields);
  Json Pause(const page::RequestFields& fields);
  Json Resume(const page::RequestFields& fields);
  Json SetSpeed(const page::RequestFields& fields);

  /// Returns `commands` in `allowed` of a state message.
  Json DescribeAllowedCommands() const;
  /// Returns `snap` of a state message.
  std::vector<std::string> snap() const { return NamesOf(snapper_.to); }
  /// Forgets copies of the world, after it was replaced.
  void Reset();

 private:
  /// Applies a command to the live world.
  /// @throws page::RequestError if it is refused.
  void Apply(const sim::Command& command);
  /// Returns the command that a page's `command` means in the present state, snapped unless it is
  /// to be exact.
  sim::Command MeantBy(const Json& wanted, bool is_exact);
  /// Returns the ids of the objects that the last command added, a spawn.
  const std::vector<std::string>& AddedObjects() const;
  /// Returns the reason for which the session refuses a command; the simulation may have others.
  std::optional<texts::UserMessage> RefusalInSession(const sim::Command& command) const;
  /// Returns the reason for which a command is refused, except reasons that depend on hands,
  /// objects and robot.
  std::optional<texts::UserMessage> RefusalOf(const sim::Command& command) const;

  StateMachine* states_;
  Snapper snapper_;
  Rehearsal rehearsal_;
  RestingPlace resting_place_;
};

}  // namespace smile::studio
