#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.h"
#include "world/refusal.h"

namespace smile::world {

using model::ControlState;

/// The states of all controls of a scene, and the rules by which they change.
///
/// A control takes a state only if it has such a state and is not in it already; only then does it
/// pass it on downstream. Each control takes at most one state per propagation, so that it ends
/// whatever the wiring.
class Controls {
 public:
  /// Begins with the states that model::InitialStates() has.
  /// @param model  must outlive this.
  explicit Controls(const model::Model& model);

  const std::vector<ControlState>& states() const { return states_; }  ///< by ControlIndex
  /// Adds the controls that a larger model has behind those of before, in their initial states.
  /// @param model  must outlive this, as the one of Restore().
  void Grow(const model::Model& model);
  void Restore(std::vector<ControlState> states, const model::Model& model);

  /// A hand presses a switch, or triggers a custom control. `part` is the button (`ID-b1`, `ID-b2`)
  /// or the id of a part of the control's present state; empty: whatever leads on.
  [[nodiscard]] std::optional<Refusal> Trigger(model::ControlIndex control, std::string_view part);
  /// Sets a state without driving anything downstream; a state it does not have is ignored.
  void Set(model::ControlIndex control, int state);
  /// Forces a state to be shown; -1 ends that.
  void Override(model::ControlIndex control, int state);

 private:
  const model::Model* model_;
  std::vector<ControlState> states_;
};

}  // namespace smile::world
