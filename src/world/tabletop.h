#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/state_hash.h"
#include "physics/world.h"
#include "scene/scene_spec.h"
#include "scene/visual_model.h"
#include "world/bonds.h"
#include "world/controls.h"
#include "world/object.h"

namespace smile::world {

/// How far below the table top a floor catches what falls [m].
inline constexpr double kFloorDepth = 0.9;

/// What can change about a tabletop apart from its bodies, whose state is the physics world's.
struct TabletopState {
  std::vector<ControlState> controls;  ///< in scene order
  std::vector<BondState> bonds;        ///< one per host point, in scene order
  std::vector<ObjectState> objects;    ///< in scene order

  bool operator==(const TabletopState&) const = default;
};

/// The scene come alive: the table, the floor and the objects of a SceneSpec as bodies of a physics
/// World, in scene order, with the sliders, chains, controls and bonds among them.
class Tabletop {
 public:
  /// Adds table, floor, objects and joints to `world`, which must outlive this.
  Tabletop(physics::World* world, const scene::SceneSpec& scene);
  Tabletop(const Tabletop&) = delete;
  Tabletop& operator=(const Tabletop&) = delete;

  /// All that the scene began with; some may be destroyed.
  const std::vector<Object>& objects() const { return objects_; }
  bool IsPresent(const Object& object) const { return world_->Has(object.body); }
  /// nullptr when there is no such object (any more).
  const Object* Find(std::string_view id) const;
  const Object* Find(physics::BodyId body) const;
  /// The object itself, or the one with a pointable part of this id.
  const Object* FindPointable(std::string_view id) const;

  /// It came to the floor, and is out of play ever since.
  bool HasFallen(const Object& object) const { return object_states_[IndexOf(object)].has_fallen; }
  /// Why hands cannot reach an object: it is destroyed, or has fallen.
  std::optional<Refusal> RefuseToReach(const Object& object) const;
  /// Or there is none of this id.
  std::optional<Refusal> RefuseToReach(std::string_view id) const;
  /// Why hands cannot point at an object or a part.
  std::optional<Refusal> RefuseToPoint(std::string_view id) const;
  /// Notices what touches the floor by now, neither held itself nor hanging on something held; to
  /// be called after each physics step. What stood down there from the start has to fall first.
  /// @returns those that had not fallen before, in scene order.
  std::vector<const Object*> NoticeFallen();

  const Controls& controls() const { return controls_; }
  const Bonds& bonds() const { return bonds_; }
  /// False once the object it belongs to is destroyed.
  bool IsPresent(const Control& control) const { return IsPresent(objects_[control.object]); }

  /// See Controls::Trigger().
  [[nodiscard]] std::optional<Refusal> Trigger(std::string_view control, std::string_view part);
  /// See Bonds::Fasten() and Bonds::Loosen(). The object must be one of objects() and present.
  [[nodiscard]] std::optional<Refusal> Fasten(const Object& object, const Vector3& p_WQ);
  [[nodiscard]] std::optional<Refusal> Loosen(const Object& object, const Vector3& p_WQ);
  /// Takes the object away, with its joints, bonds and controls. It must be present.
  void Destroy(const Object& object);

  TabletopState state() const { return {controls_.states(), bonds_.states(), object_states_}; }
  /// To be called after the physics world has been restored.
  void Restore(const TabletopState& state);
  void AddToHash(StateHash* hash) const;

  /// What there is to see: the table (drawn in the world's frame) and one frame per object.
  void AppendVisuals(scene::VisualModel* model) const;
  /// One pose per object, in scene order; one look per choice.
  void AppendVisualState(scene::VisualState* state) const;
  /// The looks of another moment.
  /// @param is_present  one per object.
  std::vector<int> LooksAt(const std::vector<ControlState>& controls,
                           const std::vector<bool>& is_present) const;

 private:
  std::size_t IndexOf(const Object& object) const {
    return static_cast<std::size_t>(&object - objects_.data());
  }
  /// The looks of an object's own controls.
  std::vector<int> LooksOf(std::size_t object) const;
  /// Adds everything that bonds may join.
  void AddBodiesAndJoints(const scene::SceneSpec& scene);
  /// The solids that are there while its controls look as they do.
  std::vector<scene::Solid> SolidsNow(std::size_t object) const;
  /// Gives objects another form whose controls looked otherwise before.
  void FollowControls(const std::vector<ControlState>& before);
  bool HasPointable(std::size_t object, std::string_view id) const;
  bool HasComeDown(std::size_t object) const;
  /// By a hand or a gripper; or something is that it hangs on.
  bool IsHeld(const Object& object) const;

  physics::World* world_;
  scene::TableSpec table_;
  double meters_per_unit_;
  physics::BodyId floor_;
  std::vector<Object> objects_;
  /// Of each object that is a chain's link: by how much it is drawn longer at both ends [m].
  std::vector<std::optional<double>> link_padding_;
  Controls controls_;
  std::vector<ObjectState> object_states_;  ///< one per object
  Bonds bonds_;
};

}  // namespace smile::world
