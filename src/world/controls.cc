#include "world/controls.h"

#include <algorithm>
#include <set>

#include "base/overloaded.h"
#include "base/wording.h"

namespace smile::world {
namespace {

using scene::CustomControl;
using scene::IndicatorLights;
using scene::ToggleSwitch;

/// A part of a custom control's state, and where triggering it leads.
struct Target {
  std::string part;
  int next_state;
};

void AppendTargets(const scene::Part& part, int inherited, std::vector<Target>* targets) {
  const int next_state = part.next_state.value_or(inherited);
  targets->push_back({part.id, next_state});
  if (const auto* composite = std::get_if<scene::Composite>(&part.shape)) {
    for (const scene::Part& child : composite->parts) AppendTargets(child, next_state, targets);
  }
}

/// Where the parts of the present state lead that lead anywhere else.
std::vector<Target> TargetsOf(const CustomControl& control, int state) {
  std::vector<Target> targets;
  for (const scene::Part& part : control.states[state].parts) AppendTargets(part, -1, &targets);
  std::erase_if(targets, [&](const Target& target) {
    return target.next_state < 0 || target.next_state == state ||
           target.next_state >= static_cast<int>(control.states.size());
  });
  return targets;
}

std::string NamesOf(const std::vector<Target>& targets) {
  std::set<std::string> names;
  for (const Target& target : targets) {
    if (!target.part.empty()) names.insert(Named(target.part));
  }
  const std::vector<std::string_view> words(names.begin(), names.end());
  return names.empty() ? "" : ": " + OneOf(words);
}

}  // namespace

Controls::Controls(const std::vector<Object>& objects) {
  for (std::size_t object = 0; object < objects.size(); ++object) {
    first_of_.push_back(controls_.size());
    for (const scene::Part* part : scene::ControlsOf(objects[object].spec->whole)) {
      index_of_[part->id] = controls_.size();
      controls_.push_back(
          {.part = {objects[object].spec, part}, .object = object, .downstream = {}});
      const auto* toggle = std::get_if<ToggleSwitch>(&part->shape);
      states_.push_back({.state = scene::InitialStateOf(*part),
                         .position = toggle && !toggle->is_left_pressed ? 1 : 0});
    }
  }
  first_of_.push_back(controls_.size());
  for (Control& control : controls_) {
    for (const std::string& id : scene::DownstreamOf(*control.part)) {
      if (const auto driven = Find(id)) control.downstream.push_back(*driven);
    }
  }
  for (std::size_t i = 0; i < controls_.size(); ++i) DriveDownstream(i);
}

std::optional<std::size_t> Controls::Find(std::string_view id) const {
  const auto found = index_of_.find(id);
  return found != index_of_.end() ? std::optional(found->second) : std::nullopt;
}

bool Controls::Take(std::size_t control, int state) {
  if (state < 0 || state >= scene::NumStatesOf(*controls_[control].part)) return false;
  if (states_[control].state == state) return false;
  states_[control].state = state;
  return true;
}

void Controls::DriveDownstream(std::size_t control) {
  std::set<std::size_t> taken{control};
  // Depth first, as they are written: the last one waiting is the next.
  std::vector<std::size_t> drivers{control};
  struct Impulse {
    std::size_t control;
    int state;
  };
  std::vector<Impulse> waiting;
  const auto drive_from = [&](std::size_t driver) {
    const int state = EffectiveState(states_[driver]);
    const auto& downstream = controls_[driver].downstream;
    for (auto next = downstream.rbegin(); next != downstream.rend(); ++next) {
      waiting.push_back({*next, state});
    }
  };
  drive_from(control);
  while (!waiting.empty()) {
    const Impulse impulse = waiting.back();
    waiting.pop_back();
    if (taken.contains(impulse.control) || !Take(impulse.control, impulse.state)) continue;
    taken.insert(impulse.control);
    drive_from(impulse.control);
  }
}

std::optional<Refusal> Controls::Trigger(std::size_t index, std::string_view part) {
  const Control& control = controls_[index];
  ControlState& state = states_[index];
  const std::string name = Named(control.id());
  const auto press = [&](const ToggleSwitch& toggle) -> std::optional<Refusal> {
    const std::string left = control.id() + "-b1", right = control.id() + "-b2";
    const std::string& raised = state.position == 0 ? right : left;
    if (!part.empty() && part != left && part != right) {
      return name + " has no button " + Named(part) + ", expected " + left + " or " + right;
    }
    if (!part.empty() && part != raised) {
      return Named(part) + " is pressed already; press " + Named(raised);
    }
    state.position = 1 - state.position;
    state.state = (state.state + 1) % toggle.num_states;
    return std::nullopt;
  };
  const auto go_on = [&](const CustomControl& custom) -> std::optional<Refusal> {
    std::vector<Target> targets = TargetsOf(custom, state.state);
    if (!part.empty()) {
      std::erase_if(targets, [part](const Target& target) { return target.part != part; });
      if (targets.empty()) {
        return "nothing would happen: " + Named(part) + " is no part of " + name +
               " as it is now, or leads nowhere";
      }
    }
    if (targets.empty()) return "nothing would happen: no part of " + name + " leads on";
    const bool is_one = std::ranges::all_of(targets, [&](const Target& target) {
      return target.next_state == targets.front().next_state;
    });
    if (!is_one)
      return "parts of " + name + " lead to different states; name one" + NamesOf(targets);
    state.state = targets.front().next_state;
    return std::nullopt;
  };
  auto refusal = std::visit(
      Overloaded{press, go_on,
                 [&](const auto&) -> std::optional<Refusal> {
                   return name + " is a row of lights: it follows others and cannot be triggered";
                 }},
      control.part->shape);
  if (!refusal) DriveDownstream(index);
  return refusal;
}

void Controls::Set(std::size_t control, int state) { Take(control, state); }

void Controls::Override(std::size_t control, int state) {
  const bool exists = state < scene::NumStatesOf(*controls_[control].part);
  states_[control].override_state = exists ? std::max(state, -1) : -1;
}

int EffectiveState(const ControlState& state) {
  return state.override_state >= 0 ? state.override_state : state.state;
}

int LookOf(const Control& control, const ControlState& state) {
  if (std::holds_alternative<ToggleSwitch>(control.part->shape)) return state.position;
  if (std::holds_alternative<IndicatorLights>(control.part->shape)) return EffectiveState(state);
  return state.state;
}

std::string RecordedState(const Control& control, const ControlState& state) {
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
    if (position == state.position) return state;
    return ControlState{.state = (state.state + 1) % toggle->num_states, .position = position};
  }
  const int num_states = scene::NumStatesOf(*control.part);
  for (int number = 0; number < num_states; ++number) {
    if (RecordedState(control, {.state = number}) == recorded) return ControlState{.state = number};
  }
  // The original gave the numbers of custom controls also where their states have names.
  for (int number = 0; number < num_states; ++number) {
    if (std::to_string(number) == recorded) return ControlState{.state = number};
  }
  return std::nullopt;
}

}  // namespace smile::world
