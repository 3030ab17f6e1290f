// State machines of controls as pure functions on values: no physics, no time. A control drives
// others by passing on its visible state number; what a number means is up to the receiver.

#include "model/control.h"

#include <algorithm>
#include <set>

#include "base/overloaded.h"

namespace smile::model {

namespace {

using scene::CustomControl;
using scene::IndicatorLights;
using scene::ToggleSwitch;

}  // namespace

int EffectiveState(const ControlState& state) {
  return state.override_state >= 0 ? state.override_state : state.state;
}

// A switch shows its position, lights show a forced state too, and a custom control shows its own
// state even if a bond forces another.
int VariantOf(const Control& control, const ControlState& state) {
  if (std::holds_alternative<ToggleSwitch>(control.part->shape)) return state.position;
  if (std::holds_alternative<IndicatorLights>(control.part->shape)) return EffectiveState(state);
  return state.state;
}

std::optional<scene::Button> PressedButtonOf(const Control& control, const ControlState& state) {
  if (!std::holds_alternative<ToggleSwitch>(control.part->shape)) return std::nullopt;
  return state.position == 0 ? scene::Button::kLeft : scene::Button::kRight;
}

std::string RecordedState(const Control& control, const ControlState& state) {
  // A state that a bond forces is recorded in place of the control's own.
  const int number = EffectiveState(state);
  const auto name_in = [number](const auto& states) {
    return states[number].name.empty() ? std::to_string(number) : states[number].name;
  };
  return std::visit(
      Overloaded{[&](const IndicatorLights& lights) { return name_in(lights.states); },
                 [&](const CustomControl& custom) { return name_in(custom.states); },
                 [&](const auto&) { return std::to_string(state.position); }},
      control.part->shape);
}

std::optional<ControlState> WithRecordedState(const Control& control, const ControlState& state,
                                              std::string_view recorded) {
  if (const auto* toggle = std::get_if<ToggleSwitch>(&control.part->shape)) {
    if (recorded != "0" && recorded != "1") return std::nullopt;
    const int position = recorded == "1" ? 1 : 0;
    // A change of position is one press of the switch, and so one state further.
    if (position == state.position) return state;
    return ControlState{.state = (state.state + 1) % toggle->num_states, .position = position};
  }
  // Names take precedence over numbers.
  const int num_states = scene::NumStatesOf(*control.part);
  for (int number = 0; number < num_states; ++number) {
    if (RecordedState(control, {.state = number}) == recorded) return ControlState{.state = number};
  }
  // The original program wrote numbers for custom controls even if their states have names.
  for (int number = 0; number < num_states; ++number) {
    if (std::to_string(number) == recorded) return ControlState{.state = number};
  }
  return std::nullopt;
}

bool TakeState(const Control& control, int state, ControlState* now) {
  if (state < 0 || state >= scene::NumStatesOf(*control.part)) return false;
  if (now->state == state) return false;
  now->state = state;
  return true;
}

void OverrideState(const Control& control, int state, ControlState* now) {
  // Only -1 means "none"; lower numbers are treated alike.
  const bool exists = state < scene::NumStatesOf(*control.part);
  now->override_state = exists ? std::max(state, -1) : -1;
}

void DriveDownstream(const std::vector<Control>& controls, ControlIndex from,
                     std::vector<ControlState>* states) {
  // Wiring may contain cycles; a control that has taken a state in this impulse takes no other.
  std::set<ControlIndex> taken{from};
  struct Impulse {
    ControlIndex control;
    int state;
  };
  // Depth first in the order of the file, as in the original: the last entry of the stack is the
  // next, so they are pushed in reverse.
  std::vector<Impulse> waiting;
  const auto drive_from = [&](ControlIndex driver) {
    const int state = EffectiveState((*states)[driver]);
    const auto& downstream = controls[driver].downstream;
    for (auto next = downstream.rbegin(); next != downstream.rend(); ++next) {
      waiting.push_back({*next, state});
    }
  };
  drive_from(from);
  while (!waiting.empty()) {
    const Impulse impulse = waiting.back();
    waiting.pop_back();
    if (taken.contains(impulse.control) ||
        !TakeState(controls[impulse.control], impulse.state, &(*states)[impulse.control])) {
      continue;
    }
    taken.insert(impulse.control);
    drive_from(impulse.control);
  }
}

std::vector<ControlState> InitialStates(const std::vector<Control>& controls) {
  std::vector<ControlState> states;
  for (const Control& control : controls) {
    const auto* toggle = std::get_if<ToggleSwitch>(&control.part->shape);
    states.push_back({.state = scene::InitialStateOf(*control.part),
                      .position = toggle && !toggle->is_left_pressed ? 1 : 0});
  }
  // Switches drive lights from the start, in the order of the file.
  for (ControlIndex control : IndexRange<ControlIndex>(controls.size())) {
    DriveDownstream(controls, control, &states);
  }
  return states;
}

}  // namespace smile::model
