#include "sim/simulation.h"

#include <utility>

#include "base/demand.h"
#include "base/overloaded.h"
#include "sim/change_detector.h"
#include "sim/command_json.h"

// The one door: every command of hands, scripts, brains and replays passes Apply(), between ticks.
// A refused command changes nothing and is not in the history; listeners receive it as an event.

namespace smile::sim {

using texts::Say;

Simulation::Simulation(std::shared_ptr<const model::Model> model)
    : running_(std::make_unique<RunningModel>(std::move(model))) {}

Simulation::Simulation(scene::SceneSpec scene, std::optional<RobotPlacement> robot)
    : Simulation(std::make_shared<const model::Model>(std::move(scene), std::move(robot))) {}

std::optional<Refusal> Simulation::Apply(const Command& wanted) {
  // Rounded as in a log, so that a replay applies the same bits.
  const Command command = OnFileGrid(wanted, scene().meters_per_unit);
  // First the rules that need no execution; the rest is refused by the parts that carry it out.
  std::optional<Refusal> refusal = Refuse(command);
  if (!refusal) {
    refusal = std::visit(
        Overloaded{
            [this](const sim::Undo&) { return Undo(), std::optional<Refusal>(); },
            [this](const sim::Redo&) { return Redo(), std::optional<Refusal>(); },
            [this](const StartRecording& start) { return recording_control_->Start(*this, start); },
            [this](const FinishRecording&) { return recording_control_->Finish(*this); },
            [&](const auto&) { return Perform(command); }},
        command);
  }
  if (refusal) Notify({.kind = EventKind::kCommandRefused, .reason = *refusal});
  return refusal;
}

std::optional<Refusal> Simulation::Refuse(const Command& command) const {
  for (Listener* listener : listeners_) {
    if (auto refusal = listener->Refuse(*this, command)) return refusal;
  }
  if (std::holds_alternative<sim::Undo>(command) && !history_.can_undo()) {
    return Say("history.nothingToUndo");
  }
  if (std::holds_alternative<sim::Redo>(command) && !history_.can_redo()) {
    return Say("history.nothingToRedo");
  }
  // Last: a listener has already refused what the recorder's state forbids.
  const bool is_of_recording = std::holds_alternative<StartRecording>(command) ||
                               std::holds_alternative<FinishRecording>(command);
  if (is_of_recording && recording_control_ == nullptr) return Say("recorder.isMissing");
  return std::nullopt;
}

void Simulation::Undo() {
  const ActionId from = history_.current().id;
  // The present state is kept with the undone action, for Redo().
  RestoreState(history_.Undo(Save()));
  NotifyMove(from);
}

void Simulation::Redo() {
  const ActionId from = history_.current().id;
  RestoreState(*history_.Redo());
  NotifyMove(from);
}

void Simulation::NotifyMove(ActionId from) {
  for (Listener* listener : listeners_) listener->OnMove(*this, from, history_.current().id);
}

std::optional<Refusal> Simulation::Perform(const Command& command) {
  // The implied releases are actions of their own, before the state for undoing the grasp is saved.
  if (const auto* grasp = std::get_if<Grasp>(&command)) ReleaseFor(*grasp);
  std::optional<SimulationState> before_action;
  // Saved for every action, also one that is refused then: only execution finds out.
  if (IsAction(command)) before_action = Save();
  const auto* load = std::get_if<sim::Load>(&command);
  std::optional<ChangeDetector> changes;
  if (load != nullptr) {
    Load(*load);
  } else {
    changes.emplace(running_.get(), command);
    if (auto refusal = running_->Execute(command)) return refusal;
  }
  has_begun_ = true;
  // The history changes only after the command succeeded.
  if (before_action) history_.Begin(*std::move(before_action));
  history_.Add({.tick = tick(), .command = command});
  // The command before its events, as cause before effect.
  for (Listener* listener : listeners_) listener->OnCommand(*this, command);
  if (load != nullptr) {
    Notify({.kind = EventKind::kLoaded, .object = scene().name});
  } else {
    for (const Event& event : changes->EventsOf(command)) Notify(event);
  }
  return std::nullopt;
}

void Simulation::Load(const sim::Load& load) {
  SMILE_DEMAND(load.scene != nullptr);
  running_ = std::make_unique<RunningModel>(
      // Another model with the same robot, at its start: nothing of the former scene remains.
      std::make_shared<const model::Model>(model(), scene::SceneSpec(*load.scene)));
}

void Simulation::ReleaseFor(const Grasp& grasp) {
  const demonstrator::GraspPlan plan = demonstrator().PlanGrasp(grasp.hand, grasp.object);
  if (plan.refusal) return;
  // By Apply(), so that they are logged, and can be undone one by one.
  for (HandName hand : plan.to_release) (void)Apply(Release{.hand = hand});
}

void Simulation::Tick() {
  has_begun_ = true;
  // Grippers may grasp or release during the tick.
  const ChangeDetector changes(running_.get());
  const TickReport report = running_->Tick();
  // The tick before its events, since these are recorded with the poses at its end.
  for (Listener* listener : listeners_) listener->OnTick(*this);
  for (const Event& event : changes.EventsOfTick(report)) Notify(event);
  for (const Refusal& reason : report.refusals) {
    Notify({.kind = EventKind::kCommandRefused, .reason = reason});
  }
  for (const world::Object* object : report.fallen) {
    Notify({.kind = EventKind::kFell, .object = object->id()});
  }
}

void Simulation::Notify(const Event& event) {
  // A refusal has no effect that undo or a recording would need.
  if (event.kind != EventKind::kCommandRefused) history_.Add(event);
  // The support is a property of the moment of release.
  std::optional<model::Support> support;
  if (event.kind == EventKind::kReleased) support = SupportOf(*model().FindObject(event.object));
  if (auto summary = SummaryOf(event, support)) {
    history_.Describe(*std::move(summary));
  }
  for (Listener* listener : listeners_) listener->OnEvent(*this, event);
}

void Simulation::Restore(const SimulationState& state) {
  RestoreState(state);
  has_begun_ = true;
  history_.Restart(tick());
}

void Simulation::RestoreState(const SimulationState& state) {
  // Across a load, the state belongs to another scene.
  if (state.start_model != start_model()) {
    running_ = std::make_unique<RunningModel>(state.start_model);
  }
  running_->Restore(state);
}

}  // namespace smile::sim
