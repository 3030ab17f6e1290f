#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/indices.h"
#include "scene/controls_of.h"

namespace smile::model {

/// State of a control.
struct ControlState {
  int state = 0;
  int override_state = -1;  ///< forced by a bond and shown instead; -1: none
  int position = 0;         ///< of a switch: 0 = left down, 1 = right down

  bool operator==(const ControlState&) const = default;
};

/// A switch, row of lights or custom control of the scene.
struct Control {
  const scene::Part* part = nullptr;       ///< in the scene; never null in a Model
  ObjectIndex object{0};                   ///< the object it belongs to
  std::vector<ControlIndex> downstream{};  ///< the controls it drives

  const std::string& id() const { return part->id; }
};

/// Returns the visible state: the forced one if any.
int EffectiveState(const ControlState& state);
/// Returns the number of the Visual::variant that shows the state.
int VariantOf(const Control& control, const ControlState& state);
/// Returns the button of a switch that is down and cannot be pressed; nullopt for other controls.
std::optional<scene::Button> PressedButtonOf(const Control& control, const ControlState& state);
/// Returns the state as in recordings: the position of a switch, else the name of the state, or its
/// number if it has no name.
std::string RecordedState(const Control& control, const ControlState& state);
/// Returns the state after `state` whose RecordedState() is `recorded`; the first one if several
/// states share the name. A switch advances by one state with each change of its position.
/// @returns nullopt if the control has no such state.
std::optional<ControlState> WithRecordedState(const Control& control, const ControlState& state,
                                              std::string_view recorded);

/// Enters a state. Returns false if the control has no such state, or is already in it.
bool TakeState(const Control& control, int state, ControlState* now);
/// Forces a visible state; -1, or a state that it does not have, ends that.
void OverrideState(const Control& control, int state, ControlState* now);
/// Passes the state of a control on to those downstream, and on from each that takes it. Each
/// control takes at most one state, so this ends whatever the wiring.
/// @param controls, states  all of the scene.
void DriveDownstream(const std::vector<Control>& controls, ControlIndex from,
                     std::vector<ControlState>* states);
/// Returns the states at the start: each control in its initial state, then passed on downstream,
/// in order.
std::vector<ControlState> InitialStates(const std::vector<Control>& controls);

}  // namespace smile::model
