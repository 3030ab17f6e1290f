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

/// The requests that command the live world, ask about it, or let its time go by.
class WorldRequests {
 public:
  /// `states` must outlive this.
  explicit WorldRequests(StateMachine* states) : states_(states) {}

  Json Command(const page::RequestFields& fields);
  /// Tries the command on a copy of the world; see RequestRow::try_out.
  std::optional<std::string> TryCommand(const page::RequestFields& fields);
  Json Spawn(const page::RequestFields& fields);
  Json Clear(const page::RequestFields& fields);
  std::optional<std::string> RefuseClear(const page::RequestFields& fields) const;
  Json SetSnap(const page::RequestFields& fields);
  Json FindSupport(const page::RequestFields& fields);
  Json AnswerRestingPlace(const page::RequestFields& fields);
  Json Pause(const page::RequestFields& fields);
  Json Resume(const page::RequestFields& fields);
  Json SetSpeed(const page::RequestFields& fields);

  /// `commands` in `allowed` of a state message.
  Json DescribeAllowedCommands() const;
  /// `snap` of a state message.
  std::vector<std::string> snap() const { return NamesOf(snapper_.to); }
  /// Another world is live.
  void Forget();

 private:
  /// Applies it through the one door.
  /// @throws page::RequestError if it is refused.
  void Apply(const sim::Command& command);
  /// Returns what a page's `command` means now, snapped unless it is to be exact.
  sim::Command MeantBy(const Json& wanted, bool is_exact);
  /// Returns why a command is refused, as far as the simulation has no part in it.
  std::optional<std::string> RefusalInSession(const sim::Command& command) const;
  /// The same as far as it does not depend on hands, objects and robot.
  std::optional<std::string> RefusalOf(const sim::Command& command) const;

  StateMachine* states_;
  Snapper snapper_;
  Rehearsal rehearsal_;
  RestingPlace resting_place_;
};

}  // namespace smile::studio
