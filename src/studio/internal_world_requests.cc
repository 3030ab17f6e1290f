#include "studio/internal_world_requests.h"

#include <memory>
#include <utility>

#include "base/wording.h"
#include "page/snap_names.h"
#include "sim/action_summary.h"
#include "sim/add.h"
#include "sim/command_json.h"
#include "sim/duplicate.h"
#include "texts/user_message.h"

// Requests about the live world become commands, and all commands pass StateMachine::Apply().
// Questions (support, resting place, allowed) never change the world: whatever must be tried is
// tried on a copy.

namespace smile::studio {

using texts::Say;
namespace {

/// True for commands about history and recordings, which a copy of the world does not have.
bool IsOfHistory(const sim::Command& command) {
  return std::holds_alternative<sim::Undo>(command) || std::holds_alternative<sim::Redo>(command) ||
         std::holds_alternative<sim::StartRecording>(command) ||
         std::holds_alternative<sim::FinishRecording>(command);
}

}  // namespace

Json WorldRequests::Command(const page::RequestFields& fields) {
  const sim::Command command = MeantBy(fields.Object("command"), fields.Flag("exact"));
  // Rules of the session first; the simulation checks the rest itself.
  if (const auto refusal = RefusalInSession(command)) throw page::RequestError(*refusal);
  Apply(command);
  const LiveWorld& world = states_->world();
  if (std::holds_alternative<sim::StartRecording>(command)) {
    return {{"recording", world.recording_directory().filename().string()}};
  }
  if (!sim::IsAction(command)) return Json::object();
  // The command began the current action.
  Json answer = {{"deed", sim::ToJson(world.simulation().history().current().summary)}};
  if (std::holds_alternative<sim::Spawn>(command)) answer["objects"] = AddedObjects();
  return answer;
}

std::optional<texts::UserMessage> WorldRequests::TryCommand(const page::RequestFields& fields) {
  // Exact, since trying a rotation must not change the memory of the snapper.
  const sim::Command command = MeantBy(fields.Object("command"), /*is_exact=*/true);
  if (auto reason = RefusalOf(command)) return reason;
  // RefusalOf() has asked the simulation itself about these.
  if (IsOfHistory(command)) return std::nullopt;
  return rehearsal_.Try(command, states_->world().simulation());
}

Json WorldRequests::Spawn(const page::RequestFields& fields) {
  const sim::Add add{.preset = fields.Text("preset"), .seed = fields.Whole("seed", sim::kMaxSeed)};
  const sim::Simulation& simulation = states_->world().simulation();
  sim::Refusal refusal;
  // The preset is expanded here, so that the log contains the objects and not the generator.
  const auto spawn = sim::SpawnOf(add, simulation, &refusal);
  if (!spawn) throw page::RequestError(refusal);
  Apply(*spawn);
  return {{"objects", AddedObjects()}};
}

Json WorldRequests::Clear(const page::RequestFields& fields) {
  if (fields.Flag("rage")) {
    states_->AnimateClearTable();
  } else {
    Apply(sim::Clear{});
  }
  return Json::object();
}

std::optional<texts::UserMessage> WorldRequests::RefuseClear(
    const page::RequestFields& fields) const {
  if (!fields.Flag("rage")) return std::nullopt;
  if (auto reason = states_->Unmet(Need::kOtherWorld)) return reason;
  if (ClearTableAnimation::IsPossible(states_->world().simulation())) return std::nullopt;
  return Say("session.noRobotToClear");
}

Json WorldRequests::SetSnap(const page::RequestFields& fields) {
  snapper_.to = SnapToOf(fields.Words("to", page::kSnapNames));
  return Json::object();
}

// Neither member if the object is in the air, on the floor or gone.
Json WorldRequests::FindSupport(const page::RequestFields& fields) {
  const sim::Simulation& simulation = states_->world().simulation();
  const std::string id = fields.Text("object");
  const auto object = simulation.model().FindObject(id);
  if (!object) throw page::RequestError(Say("session.noObject", {{"object", Quoted(id)}}));
  const auto support = simulation.SupportOf(*object);
  if (!support || !support->is_near()) return Json::object();
  return {{support->is_inside ? "into" : "on", support->object}};
}

Json WorldRequests::AnswerRestingPlace(const page::RequestFields& fields) {
  return resting_place_.Answer(states_->world().simulation(), fields.Hand("hand"),
                               states_->num_ticks(), &rehearsal_);
}

Json WorldRequests::Pause(const page::RequestFields&) {
  states_->pace().is_paused = true;
  return Json::object();
}

Json WorldRequests::Resume(const page::RequestFields&) {
  states_->pace().is_paused = false;
  return Json::object();
}

Json WorldRequests::SetSpeed(const page::RequestFields& fields) {
  states_->pace().speed_factor = fields.Number("factor", 0.1, 4);
  return Json::object();
}

Json WorldRequests::DescribeAllowedCommands() const {
  Json commands = Json::object();
  // Only the commands that have buttons of their own. For all others the page asks `allowed`.
  for (const sim::Command& command :
       {sim::Command(sim::StartRecording()), sim::Command(sim::FinishRecording()),
        sim::Command(sim::Undo()), sim::Command(sim::Redo())}) {
    const char* name = std::visit([](const auto& one) { return one.kName.name; }, command);
    commands[name] = page::AllowedUnless(RefusalOf(command));
  }
  return commands;
}

void WorldRequests::Reset() {
  rehearsal_.Reset();
  resting_place_.Reset();
}

void WorldRequests::Apply(const sim::Command& command) {
  if (const auto refusal = states_->Apply(command)) throw page::RequestError(*refusal);
}

sim::Command WorldRequests::MeantBy(const Json& wanted, bool is_exact) {
  const LiveWorld& world = states_->world();
  const double meters_per_unit = world.simulation().scene().meters_per_unit;
  // `add` and `duplicate` say which objects; the command in the log is the `spawn` of these.
  if (sim::IsAdd(wanted) || sim::IsDuplicate(wanted)) {
    sim::Refusal refusal;
    const auto spawn =
        sim::IsAdd(wanted)
            ? sim::SpawnOf(sim::ParseAdd(wanted, meters_per_unit), world.simulation(), &refusal)
            : sim::SpawnOf(sim::ParseDuplicate(wanted, meters_per_unit), world.simulation(),
                           &refusal);
    if (!spawn) throw page::RequestError(refusal);
    return *spawn;
  }
  // A drag is a motion of the mouse; the command is the motion of the hand that follows from it.
  if (!sim::IsDrag(wanted)) {
    const sim::Command command = sim::ParseCommand(wanted, meters_per_unit);
    return is_exact ? command : snapper_.Snapped(world, command);
  }
  const sim::Drag drag = sim::ParseDrag(wanted, meters_per_unit);
  sim::Refusal refusal;
  const auto move = is_exact ? sim::MoveOf(drag, world.simulation(), &refusal)
                             : snapper_.MoveOf(world, drag, &refusal);
  if (!move) throw page::RequestError(refusal);
  return *move;
}

const std::vector<std::string>& WorldRequests::AddedObjects() const {
  // A spawn is an action, and its event lists the ids that the objects received.
  return states_->world().simulation().history().current().events.front().objects;
}

std::optional<texts::UserMessage> WorldRequests::RefusalInSession(
    const sim::Command& command) const {
  // A program cannot be rewound together with the world.
  const bool turns_back =
      std::holds_alternative<sim::Undo>(command) || std::holds_alternative<sim::Redo>(command);
  if (turns_back && states_->brain().is_running()) {
    return Say("brain.cannotGoBack");
  }
  if (std::holds_alternative<sim::StartRecording>(command)) {
    return states_->Unmet(Need::kNewRecording);
  }
  return std::holds_alternative<sim::Load>(command) ? states_->Unmet(Need::kOtherWorld)
                                                    : std::nullopt;
}

std::optional<texts::UserMessage> WorldRequests::RefusalOf(const sim::Command& command) const {
  if (auto reason = states_->Unmet(Need::kCommands)) return reason;
  if (auto reason = RefusalInSession(command)) return reason;
  return states_->world().simulation().Refuse(command);
}

}  // namespace smile::studio
