#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/shared_list.h"
#include "base/state_hash.h"
#include "model/model.h"
#include "physics/world.h"
#include "world/bonds.h"
#include "world/controls.h"
#include "world/object.h"
#include "world/object_states.h"
#include "world/presses.h"
#include "world/tools.h"

namespace smile::world {

/// Depth of the floor below the table top [m].
inline constexpr double kFloorDepth = 0.9;

/// State of a tabletop apart from its bodies, whose state is part of the physics world.
struct TabletopState {
  std::vector<ControlState> controls;  ///< by model::ControlIndex
  std::vector<BondState> bonds;        ///< by model::HostIndex
  std::vector<PressState> presses;     ///< by model::ControlIndex
  ToolsState tools;
  ObjectStates objects;
  SharedList<physics::BodyId> bodies;  ///< of the objects, including destroyed ones

  bool operator==(const TabletopState&) const = default;
};

/// The running scene: the table, the floor and the objects of a SceneSpec as bodies of a physics
/// World, in scene order, with their sliders, chains, controls and bonds.
class Tabletop {
 public:
  /// Adds table, floor, objects and joints to `world`, which must outlive this.
  Tabletop(physics::World* world, std::shared_ptr<const model::Model> model);
  /// Makes a model of the scene, without a robot.
  Tabletop(physics::World* world, scene::SceneSpec scene);
  Tabletop(const Tabletop&) = delete;
  Tabletop& operator=(const Tabletop&) = delete;

  /// Adds the objects and joints that a larger model has behind the present ones. Present objects
  /// keep their state to the last bit.
  void Grow(std::shared_ptr<const model::Model> model);

  /// Returns all objects of the model, including destroyed ones.
  const std::vector<Object>& objects() const { return objects_; }
  bool IsPresent(const Object& object) const { return world_->Has(object.body); }
  /// Return the object, or nullptr if it does not exist or was destroyed.
  const Object* Find(std::string_view id) const;
  const Object* Find(physics::BodyId body) const;
  /// Returns the object with this id or with a pointable part of this id.
  const Object* FindPointable(std::string_view id) const;

  /// Returns true once an object has fallen to the floor; it is then out of play.
  bool HasFallen(const Object& object) const { return object_states_[object.index].has_fallen; }
  /// Return the reason why hands cannot reach an object: it is destroyed, has fallen, or (by id)
  /// does not exist.
  std::optional<Refusal> RefuseToReach(const Object& object) const;
  std::optional<Refusal> RefuseToReach(std::string_view id) const;
  /// Returns the reason why hands cannot point at an object or a part.
  std::optional<Refusal> RefuseToPoint(std::string_view id) const;
  /// Call after each physics step: marks objects as fallen that touch the floor and are neither
  /// held nor connected with a held one. An object that started down there must fall first.
  /// @returns those that had not fallen before, in scene order.
  std::vector<const Object*> NoticeFallen();
  /// Call after each physics step: notes which controls are pushed.
  void NoticePushes() { presses_.AfterStep(); }
  /// Call after the steps of a tick, which took `seconds`: triggers the controls that contact
  /// pressed.
  /// @returns the presses.
  std::vector<Press> PressControls(double seconds);
  /// Returns true if contact can press a control.
  bool has_pressable_controls() const { return !presses_.is_empty(); }

  const model::Model& model() const { return *model_; }
  const Controls& controls() const { return controls_; }
  const Bonds& bonds() const { return bonds_; }
  /// Returns false once the control's object is destroyed.
  bool IsPresent(model::ControlIndex control) const {
    return IsPresent(objects_[model_->control(control).object]);
  }

  /// See Controls::Trigger().
  [[nodiscard]] std::optional<Refusal> Trigger(std::string_view control, std::string_view part);
  /// See Bonds::Fasten() and Bonds::Loosen(). The object must be one of objects() and present.
  [[nodiscard]] std::optional<Refusal> Fasten(const Object& object, const Vector3& p_WQ);
  [[nodiscard]] std::optional<Refusal> Loosen(const Object& object, const Vector3& p_WQ);
  /// See Tools::PlanUse(); refuses objects that are no tools.
  std::optional<ToolUse> PlanUse(const Object& tool, bool loosens, Refusal* refusal) const;
  /// See Tools::NearestWork(); nullopt for objects that are no tools.
  std::optional<WorkPlace> NearestWork(const Object& tool) const;
  /// See Tools::Use().
  void Use(const ToolUse& use);
  /// See Tools::PossibleUses().
  std::vector<ToolUse> PossibleUses(const std::vector<Holder>& holders) const {
    return tools_.PossibleUses(holders);
  }
  /// Call after the steps of a tick; see Tools::AfterTick().
  std::vector<ToolUse> UseTools(const std::vector<Holder>& holders, std::vector<Refusal>* refusals);
  bool has_tools() const { return !tools_.is_empty(); }
  /// Removes a present object, with its joints, bonds and controls.
  void Destroy(const Object& object);

  TabletopState state() const;
  /// Restores a state. Call after the physics world has been restored.
  /// @param model  the one of the state.
  void Restore(const TabletopState& state, std::shared_ptr<const model::Model> model);
  void AddToHash(StateHash* hash) const;

  /// Returns the visible state.
  model::SceneState scene_state() const;
  /// Returns X_WB of an object; nullopt if it is destroyed.
  std::optional<RigidTransform> PoseOf(const Object& object) const;

 private:
  /// Part of the model that is already in the world.
  struct Extent {
    std::size_t num_objects = 0, num_sliders = 0, num_chains = 0, num_guests = 0;
  };
  /// Adds the part of the model beyond `extent`.
  void AddBeyond(const Extent& extent);
  void AddBody(Object* object);
  /// Returns the solids of an object in the present states of its controls.
  std::vector<scene::Solid> SolidsNow(const Object& object) const;
  /// Changes the form of objects whose controls looked different before.
  void FollowControls(const std::vector<ControlState>& before);
  bool HasPointable(const Object& object, std::string_view id) const;
  bool HasComeDown(const Object& object) const;
  /// Returns true if a hand or a gripper holds the object or one connected with it.
  bool IsHeld(const Object& object) const;

  physics::World* world_;
  std::shared_ptr<const model::Model> model_;
  physics::BodyId floor_;
  std::vector<Object> objects_;
  SharedList<physics::BodyId> bodies_;  ///< of the objects, as each state contains them
  Controls controls_;
  ObjectStates object_states_;
  Presses presses_;
  Bonds bonds_;
  Tools tools_;
};

}  // namespace smile::world
