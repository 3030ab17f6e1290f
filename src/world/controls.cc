#include "world/controls.h"

#include <algorithm>
#include <set>

#include "base/overloaded.h"
#include "base/wording.h"
#include "scene/controls_of.h"

// Rules of switches and custom controls: what happens when a hand triggers them. The states of all
// controls are in one list by index, and the model has the wiring that drives other controls.

namespace smile::world {

using texts::Say;
namespace {

using scene::CustomControl;
using scene::IndicatorLights;
using scene::ToggleSwitch;

/// A part of a custom control's state and the state it leads to.
struct Target {
  std::string part;
  int next_state;
  bool is_cut;  ///< only tools trigger it
};

/// Appends a part and its children; children inherit the next state unless they name one.
void AppendTargets(const scene::Part& part, const Target& inherited, std::vector<Target>* targets) {
  Target target{part.id, part.next_state.value_or(inherited.next_state), inherited.is_cut};
  if (part.trigger) target.is_cut = part.trigger->cause == scene::TriggerCause::kCut;
  targets->push_back(target);
  if (const auto* composite = std::get_if<scene::Composite>(&part.shape)) {
    for (const scene::Part& child : composite->parts) AppendTargets(child, target, targets);
  }
}

/// Returns the parts of the present state that lead to another state.
std::vector<Target> TargetsOf(const CustomControl& control, int state) {
  std::vector<Target> targets;
  // -1: at the top level nothing is inherited, so such parts lead nowhere.
  for (const scene::Part& part : control.states[state].parts) {
    AppendTargets(part, {.part = {}, .next_state = -1, .is_cut = false}, &targets);
  }
  std::erase_if(targets, [&](const Target& target) {
    return target.next_state < 0 || target.next_state == state ||
           target.next_state >= static_cast<int>(control.states.size());
  });
  return targets;
}

/// Returns the names of parts as `'a', 'b' or 'c'`, sorted and unique; empty if none has a name.
std::string NamesOf(const std::vector<Target>& targets) {
  std::set<std::string> names;
  for (const Target& target : targets) {
    if (!target.part.empty()) names.insert(Named(target.part));
  }
  const std::vector<std::string_view> words(names.begin(), names.end());
  return OneOf(words);
}

}  // namespace

Controls::Controls(const model::Model& model)
    : model_(&model), states_(model::InitialStates(model.all_controls())) {}

void Controls::Grow(const model::Model& model) {
  const std::vector<ControlState> initial = model::InitialStates(model.all_controls());
  for (std::size_t i = states_.size(); i < initial.size(); ++i) states_.push_back(initial[i]);
  model_ = &model;
}

void Controls::Restore(std::vector<ControlState> states, const model::Model& model) {
  states_ = std::move(states);
  model_ = &model;
}

std::optional<Refusal> Controls::Trigger(model::ControlIndex index, std::string_view part) {
  const model::Control& control = model_->control(index);
  ControlState& state = states_[index];
  const std::string& name = control.id();
  const auto press = [&](const ToggleSwitch& toggle) -> std::optional<Refusal> {
    const std::string left = scene::ButtonId(control.id(), scene::Button::kLeft);
    const std::string right = scene::ButtonId(control.id(), scene::Button::kRight);
    // A switch is a rocker: one button is always down.
    const bool is_left_down = PressedButtonOf(control, state) == scene::Button::kLeft;
    const std::string& raised = is_left_down ? right : left;
    if (!part.empty() && part != left && part != right) {
      return Say("controls.noButton",
                 {{"control", name}, {"button", part}, {"left", left}, {"right", right}});
    }
    // Only the raised button can be pressed.
    if (!part.empty() && part != raised) {
      return Say("controls.isPressed", {{"button", part}, {"other", raised}});
    }
    TurnOver(toggle, &state);
    return std::nullopt;
  };
  const auto advance = [&](const CustomControl& custom) -> std::optional<Refusal> {
    std::vector<Target> targets = TargetsOf(custom, state.state);
    if (!part.empty()) {
      std::erase_if(targets, [part](const Target& target) { return target.part != part; });
      if (targets.empty()) {
        return Say("controls.notAPart", {{"part", part}, {"control", name}});
      }
    }
    if (targets.empty()) return Say("controls.leadsNowhere", {{"control", name}});
    if (targets.front().is_cut) return Say("controls.bareHands", {{"control", name}});
    // Without a named part, all parts must agree.
    const bool is_one = std::ranges::all_of(targets, [&](const Target& target) {
      return target.next_state == targets.front().next_state;
    });
    if (!is_one) {
      const std::string parts = NamesOf(targets);
      return parts.empty() ? Say("controls.isAmbiguous", {{"control", name}})
                           : Say("controls.nameOne", {{"control", name}, {"parts", parts}});
    }
    state.state = targets.front().next_state;
    return std::nullopt;
  };
  auto refusal = std::visit(Overloaded{press, advance,
                                       [&](const auto&) -> std::optional<Refusal> {
                                         return Say("controls.areLights", {{"control", name}});
                                       }},
                            control.part->shape);
  // Other controls follow only after the control has changed itself.
  if (!refusal) model::DriveDownstream(model_->all_controls(), index, &states_);
  return refusal;
}

void Controls::TurnOver(const ToggleSwitch& toggle, ControlState* state) {
  // The lowered button comes up and the other one goes down; the state advances either way.
  state->position = 1 - state->position;
  state->state = (state->state + 1) % toggle.num_states;
}

bool Controls::CanPress(model::ControlIndex index, int next_state) const {
  const model::Control& control = model_->control(index);
  ControlState state = states_[index];
  return std::holds_alternative<ToggleSwitch>(control.part->shape) ||
         model::TakeState(control, next_state, &state);
}

bool Controls::Press(model::ControlIndex index, int next_state) {
  if (!CanPress(index, next_state)) return false;
  const model::Control& control = model_->control(index);
  if (const auto* toggle = std::get_if<ToggleSwitch>(&control.part->shape)) {
    TurnOver(*toggle, &states_[index]);
  } else {
    model::TakeState(control, next_state, &states_[index]);
  }
  model::DriveDownstream(model_->all_controls(), index, &states_);
  return true;
}

void Controls::Set(model::ControlIndex control, int state) {
  model::TakeState(model_->control(control), state, &states_[control]);
}

void Controls::Override(model::ControlIndex control, int state) {
  model::OverrideState(model_->control(control), state, &states_[control]);
}

}  // namespace smile::world
