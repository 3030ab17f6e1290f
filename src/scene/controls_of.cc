#include "scene/controls_of.h"

#include <stdexcept>

#include "base/overloaded.h"

namespace smile::scene {
namespace {

/// Appends the controls of a part in the order of the file. Nothing inside a control is a control.
void AppendControls(const Part& part, std::vector<const Part*>* controls) {
  if (IsControl(part.shape)) controls->push_back(&part);
  if (const auto* composite = std::get_if<Composite>(&part.shape)) {
    for (const Part& child : composite->parts) AppendControls(child, controls);
  }
}

/// Calls `of` with the control's own type; throws std::logic_error if the part is not a control.
template <class Result, class Function>
Result Ask(const Part& control, Function of) {
  return std::visit(
      [&](const auto& shape) -> Result {
        // Exactly the controls have this member.
        if constexpr (requires { shape.initial_state; }) {
          return of(shape);
        } else {
          throw std::logic_error("part '" + control.id + "' is not a control");
        }
      },
      control.shape);
}

}  // namespace

std::vector<const Part*> ControlsOf(const Part& whole) {
  std::vector<const Part*> controls;
  AppendControls(whole, &controls);
  return controls;
}

std::string KindOf(const Part& control) {
  return Ask<std::string>(
      control, Overloaded{[](const ToggleSwitch&) -> std::string { return "toggleSwitch"; },
                          [](const IndicatorLights&) -> std::string { return "indicatorLights"; },
                          [](const CustomControl& custom) { return custom.name; }});
}

std::string ButtonId(const std::string& switch_id, Button button) {
  // These names are part of commands and recordings.
  return switch_id + (button == Button::kLeft ? "-b1" : "-b2");
}

int NumStatesOf(const Part& control) {
  return Ask<int>(
      control, Overloaded{[](const ToggleSwitch& toggle) { return toggle.num_states; },
                          [](const auto& other) { return static_cast<int>(other.states.size()); }});
}

int InitialStateOf(const Part& control) {
  return Ask<int>(control, [](const auto& any) { return any.initial_state; });
}

const std::vector<std::string>& DownstreamOf(const Part& control) {
  return Ask<const std::vector<std::string>&>(
      control, [](const auto& any) -> const std::vector<std::string>& { return any.downstream; });
}

std::vector<Solid> SolidsWith(const std::vector<int>& variants, const std::vector<Solid>& solids) {
  std::vector<Solid> present;
  for (const Solid& solid : solids) {
    // Solids outside of controls are always there.
    if (solid.control < 0 || variants.at(solid.control) == solid.variant) present.push_back(solid);
  }
  return present;
}

}  // namespace smile::scene
