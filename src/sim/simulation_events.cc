// What a simulation tells its listeners.

#include <algorithm>

#include "base/overloaded.h"
#include "sim/simulation.h"

namespace smile::sim {
namespace {

/// True of a command that adds or takes away objects, whoever it is from.
bool ChangesObjects(const Command& command) {
  return std::holds_alternative<Spawn>(command) || std::holds_alternative<Remove>(command) ||
         std::holds_alternative<Clear>(command);
}

}  // namespace

std::vector<std::vector<physics::BodyId>> Simulation::HeldByGrippers() const {
  std::vector<std::vector<physics::BodyId>> held;
  for (int arm = 0; robot_ && arm < robot_->num_arms(); ++arm) {
    held.push_back(robot_->HeldBodies(arm));
  }
  return held;
}

void Simulation::TellOfGrippers(const std::vector<std::vector<physics::BodyId>>& before) {
  const auto after = HeldByGrippers();
  if (after == before) return;
  for (std::size_t arm = 0; arm < after.size(); ++arm) {
    const auto tell_of_missing = [&](const auto& from, const auto& in, EventKind kind) {
      for (physics::BodyId body : from) {
        if (std::find(in.begin(), in.end(), body) != in.end()) continue;
        Tell({.kind = kind,
              .arm = robot_->model().arms[arm].name,
              .object = tabletop_.Find(body)->id()});
      }
    };
    tell_of_missing(before[arm], after[arm], EventKind::kGripperLetGo);
    tell_of_missing(after[arm], before[arm], EventKind::kGripperHolds);
  }
}

Simulation::Before Simulation::LookBefore(const Command& command) const {
  Before before;
  if (const auto hand = HandOf(command)) {
    const world::Object* held = tabletop_.Find(demonstrator_.hand(*hand).held);
    if (held != nullptr) before.held = held->id();
  }
  if (!ChangesObjects(command)) return before;
  for (const world::Object& object : tabletop_.objects()) {
    before.were_present.push_back(tabletop_.IsPresent(object));
  }
  return before;
}

std::vector<std::string> Simulation::ChangedSince(const Before& before) const {
  std::vector<std::string> changed;
  for (const world::Object& object : tabletop_.objects()) {
    const bool was_present =
        object.index < before.were_present.size() && before.were_present[object.index];
    if (was_present != tabletop_.IsPresent(object)) changed.push_back(object.id());
  }
  return changed;
}

void Simulation::TellOfCommand(const Command& command, const Before& before) {
  const std::string& held_before = before.held;
  std::visit(
      Overloaded{
          [this](const Grasp& grasp) {
            Tell({.kind = EventKind::kGrasped, .hand = grasp.hand, .object = grasp.object});
          },
          [&](const Release& release) {
            Tell({.kind = EventKind::kReleased, .hand = release.hand, .object = held_before});
          },
          [&](const Destroy& destroy) {
            Tell({.kind = EventKind::kDestroyed, .hand = destroy.hand, .object = held_before});
          },
          [&](const Attend& attend) {
            const world::Object& object = *tabletop_.Find(held_before);
            Tell({.kind = EventKind::kAttended,
                  .hand = attend.hand,
                  .object = object.id(),
                  .properties = demonstrator_.PropertiesThatMatter(object)});
          },
          [this](const Point& point) {
            Tell({.kind = EventKind::kPointed,
                  .hand = point.hand,
                  .object = tabletop_.FindPointable(point.part)->id(),
                  .part = point.part});
          },
          [this](const Trigger& trigger) {
            const auto control = model_->FindControl(trigger.control);
            Tell({.kind = EventKind::kTriggered,
                  .hand = trigger.hand,
                  .object = model_->id(model_->control(*control).object),
                  .control = trigger.control});
          },
          [&](const Spawn&) { Tell({.kind = EventKind::kAdded, .objects = ChangedSince(before)}); },
          [&](const Remove&) {
            Tell({.kind = EventKind::kRemoved, .objects = ChangedSince(before)});
          },
          [&](const Clear&) {
            Tell({.kind = EventKind::kCleared, .objects = ChangedSince(before)});
          },
          [](const auto&) {}},
      command);
}

void Simulation::TellOfBonds(const std::vector<world::BondState>& before,
                             std::optional<HandName> hand) {
  for (model::HostIndex host : IndexRange<model::HostIndex>(before.size())) {
    const world::BondState& was = before[host];
    const world::BondState& is = tabletop_.bonds().states()[host];
    if (was.tightness == is.tightness) continue;
    const model::GuestIndex guest = is.guest ? *is.guest : *was.guest;
    Tell({.kind = is.tightness > was.tightness ? EventKind::kFastened : EventKind::kLoosened,
          .hand = hand,
          .object = model_->id(model_->guest(guest).object),
          .guest = guest,
          .host = host,
          .tightness = is.tightness});
  }
}

void Simulation::TellOfControls(const std::vector<model::ControlState>& before) {
  for (model::ControlIndex i : IndexRange<model::ControlIndex>(before.size())) {
    if (before[i] == tabletop_.controls().states()[i]) continue;
    const model::Control& control = model_->control(i);
    if (!tabletop_.IsPresent(i)) continue;
    const std::string state = RecordedState(control, tabletop_.controls().states()[i]);
    if (state == RecordedState(control, before[i])) continue;
    Tell({.kind = EventKind::kControlChanged,
          .object = model_->id(control.object),
          .control = control.id(),
          .state = state});
  }
}

std::optional<model::Support> Simulation::SupportOf(model::ObjectIndex index) const {
  std::vector<std::optional<RigidTransform>> X_WBs;
  for (const world::Object& object : tabletop_.objects()) {
    X_WBs.push_back(tabletop_.IsPresent(object)
                        ? std::optional(physics_.body(object.body).pose_in_world())
                        : std::nullopt);
  }
  return model::SupportOf(scene(), X_WBs, index);
}

void Simulation::Tell(const Event& event) {
  if (event.kind != EventKind::kCommandRefused) history_.Add(event);
  std::optional<model::Support> support;
  if (event.kind == EventKind::kReleased) support = SupportOf(*model_->FindObject(event.object));
  if (auto summary = SummaryOf(event, support)) {
    history_.Describe(*std::move(summary));
  }
  for (Listener* listener : listeners_) listener->OnEvent(*this, event);
}

}  // namespace smile::sim
