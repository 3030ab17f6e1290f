#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/indices.h"
#include "scene/controls_of.h"

namespace smile::model {

/// What can change about a control.
struct ControlState {
  int state = 0;
  int override_state = -1;  ///< forced by a bond and shown instead; -1: none
  int position = 0;         ///< of a switch: 0 = left down, 1 = right down

  bool operator==(const ControlState&) const = default;
};

/// A switch, row of lights or custom control of the scene.
struct Control {
  const scene::Part* part = nullptr;       ///< of the scene; never null in a Model
  ObjectIndex object{0};                   ///< the object it belongs to
  std::vector<ControlIndex> downstream{};  ///< the controls it drives

  const std::string& id() const { return part->id; }
};

/// The state others see: the forced one where there is one.
int EffectiveState(const ControlState& state);
/// The number of the Visual::look that shows the state.
int LookOf(const Control& control, const ControlState& state);
/// The button of a switch that is down and cannot be pressed; nullopt of other controls.
std::optional<scene::Button> PressedButtonOf(const Control& control, const ControlState& state);
/// The state as recordings write it: the position of a switch, else the name of the state, or its
/// number where it has no name.
std::string RecordedState(const Control& control, const ControlState& state);
/// The state after `state` whose RecordedState() is `recorded`; of states with one name the first.
/// A switch advances by one state with every change of its position.
/// @returns nullopt if the control has no such state.
std::optional<ControlState> WithRecordedState(const Control& control, const ControlState& state,
                                              std::string_view recorded);

/// Enters a state. False if the control has no such state, or is in it already.
bool TakeState(const Control& control, int state, ControlState* now);
/// Forces a state to be shown; -1, and a state it does not have, ends that.
void OverrideState(const Control& control, int state, ControlState* now);
/// Passes the state of a control on to those downstream, and from each that took it further on.
/// Each control takes at most one state, so that it ends whatever the wiring.
/// @param controls, states  all of the scene.
void DriveDownstream(const std::vector<Control>& controls, ControlIndex from,
                     std::vector<ControlState>* states);
/// The states at the start: each control in its initial state and then, in order, passed on
/// downstream.
std::vector<ControlState> InitialStates(const std::vector<Control>& controls);

}  // namespace smile::model
