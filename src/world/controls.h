#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.h"
#include "world/refusal.h"

namespace smile::world {

using model::ControlState;

/// States of all controls of a scene, and the rules by which they change.
///
/// A control takes a state only if it has such a state and is not already in it; only then does it
/// pass the state on downstream. Each control takes at most one state per propagation, so
/// propagation ends whatever the wiring.
class Controls {
 public:
  /// Starts with model::InitialStates().
  /// @param model  must outlive this.
  explicit Controls(const model::Model& model);

  const std::vector<ControlState>& states() const { return states_; }  ///< by ControlIndex
  /// Adds the controls that a larger model has behind the present ones, in their initial states.
  /// @param model  must outlive this, as the one of Restore().
  void Grow(const model::Model& model);
  void Restore(std::vector<ControlState> states, const model::Model& model);

  /// Presses a switch, or triggers a custom control. `part` is the button (`ID-b1`, `ID-b2`) or the
  /// id of a part of the control's present state; empty: any part that leads to another state.
  [[nodiscard]] std::optional<Refusal> Trigger(model::ControlIndex control, std::string_view part);
  /// Returns whether Press() would change something.
  bool CanPress(model::ControlIndex control, int next_state) const;
  /// Triggers a control as contact does.
  /// @param next_state  of a custom control; a switch takes the next of its own.
  /// @returns false if nothing changes.
  bool Press(model::ControlIndex control, int next_state);
  /// Sets a state without driving downstream controls; ignores a state that the control does not
  /// have.
  void Set(model::ControlIndex control, int state);
  /// Forces a displayed state; -1 ends that.
  void Override(model::ControlIndex control, int state);

 private:
  /// Turns a switch over.
  void TurnOver(const scene::ToggleSwitch& toggle, ControlState* state);

  const model::Model* model_;
  std::vector<ControlState> states_;
};

}  // namespace smile::world
