#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/controls_of.h"
#include "world/object.h"
#include "world/refusal.h"

namespace smile::world {

/// What can change about a control.
struct ControlState {
  int state = 0;
  int override_state = -1;  ///< what a bond forces it to show instead; -1: nothing
  int position = 0;         ///< of a switch: 0 = left down, 1 = right down

  bool operator==(const ControlState&) const = default;
};

/// A control of the scene, alive.
struct Control {
  std::shared_ptr<const scene::Part> part;  ///< shares the object's spec
  std::size_t object;                       ///< index of its object
  std::vector<std::size_t> downstream;      ///< indices of the controls it drives

  const std::string& id() const { return part->id; }
};

/// All switches, lights and custom controls of a scene, in scene order, and how they drive one
/// another.
///
/// A control takes a state only if it has such a state and is not in it already; only then does it
/// pass it on downstream. Each control takes at most one state per propagation, so that it ends
/// whatever the wiring.
class Controls {
 public:
  /// Every control starts in its initial state and then, in scene order, sets those downstream of
  /// it.
  explicit Controls(const std::vector<Object>& objects);

  const std::vector<Control>& all() const { return controls_; }
  const std::vector<ControlState>& states() const { return states_; }
  void Restore(std::vector<ControlState> states) { states_ = std::move(states); }
  std::optional<std::size_t> Find(std::string_view id) const;
  /// Indices of an object's own controls: from the first up to, not including, the second.
  std::pair<std::size_t, std::size_t> RangeOf(std::size_t object) const {
    return {first_of_[object], first_of_[object + 1]};
  }

  /// A hand presses a switch, or triggers a custom control. `part` is the button (`ID-b1`, `ID-b2`)
  /// or the id of a part of the control's present state; empty: whatever leads on.
  [[nodiscard]] std::optional<Refusal> Trigger(std::size_t control, std::string_view part);
  /// Sets a state without driving anything downstream; a state it does not have is ignored.
  void Set(std::size_t control, int state);
  /// Forces a state to be shown; -1 ends that.
  void Override(std::size_t control, int state);

 private:
  /// False when it has no such state, or has it already.
  bool Take(std::size_t control, int state);
  void DriveDownstream(std::size_t control);

  std::vector<Control> controls_;
  std::vector<std::size_t> first_of_;  ///< of each object, its first control; one more at the end
  std::map<std::string, std::size_t, std::less<>> index_of_;
  std::vector<ControlState> states_;
};

/// The state others see: the forced one while there is one.
int EffectiveState(const ControlState& state);
/// How the control looks: the number of its Visual::look.
int LookOf(const Control& control, const ControlState& state);
/// As recordings have it: the position of a switch, else the name of the state, or its number where
/// it has no name.
std::string RecordedState(const Control& control, const ControlState& state);
/// What becomes of a state when a recording says this: RecordedState() of it is `recorded`. Of
/// states with one name it is the first. A switch goes on by one state with every change of its
/// position.
/// @returns nullopt if the control has no such state.
std::optional<ControlState> WithRecordedState(const Control& control, const ControlState& state,
                                              std::string_view recorded);

}  // namespace smile::world
