#pragma once

#include <vector>

#include "base/state_hash.h"
#include "physics/world.h"
#include "scene/solid.h"
#include "world/controls.h"
#include "world/object.h"
#include "world/object_states.h"

namespace smile::world {

/// First physics version in which contact presses controls.
inline constexpr int kPressVersion = 4;

/// State of a control that contact may press.
struct PressState {
  /// Force below which it is released [N]; 0: it is not pressed.
  double release_force = 0;
  physics::BodyId by{};  ///< body that pressed it; none for a link
  int quiet_ticks = 0;   ///< for which the force was below release_force

  bool is_pressed() const { return release_force > 0; }
  bool operator==(const PressState&) const = default;
};

/// A press of a control by contact, and its cause.
struct Press {
  model::ControlIndex control{0};
  physics::BodyId by{};  ///< none if a link of the robot pressed it
  int by_link = -1;      ///< -1: none, or the robot's base
};

/// Contact that presses switches and parts of controls: once when the force exceeds a threshold
/// within an angle of its axis, and again only after it was released. The force is the mean of a
/// tick, so that a light object that bumps into a button does not press it.
class Presses {
 public:
  /// All must outlive this.
  Presses(physics::World* world, const model::Model& model, const std::vector<Object>* objects,
          const ObjectStates* object_states);
  /// Adds the controls that a larger model has behind the present ones.
  /// @param model  must outlive this, as the one of Restore().
  void Grow(const model::Model& model);

  const std::vector<PressState>& states() const { return states_; }  ///< by ControlIndex
  void Restore(std::vector<PressState> states, const model::Model& model);
  /// Returns true if no control can be pressed by contact.
  bool is_empty() const { return pressable_.empty(); }

  /// Call after each physics step: collects its pushes.
  void AfterStep();
  /// Call after the steps of a tick: triggers what was pressed.
  /// @returns the presses, by control.
  std::vector<Press> AfterTick(double tick_seconds, Controls* controls);
  void AddToHash(StateHash* hash) const;

 private:
  /// Object with something to press.
  struct Pressable {
    model::ObjectIndex object{0};
    std::vector<scene::Solid> solids;  ///< of all variants
  };
  /// Pushes of a tick on one control.
  struct Pushed;

  void FindPressable();
  /// Returns the solid that was pushed; nullptr if the object has no such solid.
  /// @param variants  of the object's controls in the tick.
  static const scene::Solid* SolidOf(const Pressable& pressable, const physics::Push& push,
                                     const std::vector<int>& variants);
  Pushed Sum(const Pressable& pressable, int control, const std::vector<int>& variants) const;
  /// Returns true if pushes of this tick do not show whether the control is still pressed.
  bool IsAsleep(const Pressable& pressable, const PressState& state) const;

  physics::World* world_;
  const model::Model* model_;
  const std::vector<Object>* objects_;
  const ObjectStates* object_states_;
  std::vector<Pressable> pressable_;  ///< in scene order
  std::vector<PressState> states_;
  std::vector<physics::Push> pushes_;  ///< of the present tick; empty between ticks
};

}  // namespace smile::world
