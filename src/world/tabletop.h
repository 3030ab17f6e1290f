#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/state_hash.h"
#include "model/model.h"
#include "physics/world.h"
#include "world/bonds.h"
#include "world/controls.h"
#include "world/object.h"

namespace smile::world {

/// How far below the table top a floor catches what falls [m].
inline constexpr double kFloorDepth = 0.9;

/// What can change about a tabletop apart from its bodies, whose state is the physics world's.
struct TabletopState {
  std::vector<ControlState> controls;   ///< by model::ControlIndex
  std::vector<BondState> bonds;         ///< by model::HostIndex
  std::vector<ObjectState> objects;     ///< in scene order
  std::vector<physics::BodyId> bodies;  ///< of the objects, also of those that are gone

  bool operator==(const TabletopState&) const = default;
};

/// The scene come alive: the table, the floor and the objects of a SceneSpec as bodies of a physics
/// World, in scene order, with the sliders, chains, controls and bonds among them.
class Tabletop {
 public:
  /// Adds table, floor, objects and joints to `world`, which must outlive this.
  Tabletop(physics::World* world, std::shared_ptr<const model::Model> model);
  /// Of a model of its own, without a robot.
  Tabletop(physics::World* world, scene::SceneSpec scene);
  Tabletop(const Tabletop&) = delete;
  Tabletop& operator=(const Tabletop&) = delete;

  /// Adds to `world` the objects and joints that a larger model has behind those of before. What
  /// was there keeps its state to the last bit.
  void Grow(std::shared_ptr<const model::Model> model);

  /// All that the model has; some may be destroyed.
  const std::vector<Object>& objects() const { return objects_; }
  bool IsPresent(const Object& object) const { return world_->Has(object.body); }
  /// nullptr when there is no such object (any more).
  const Object* Find(std::string_view id) const;
  const Object* Find(physics::BodyId body) const;
  /// The object itself, or the one with a pointable part of this id.
  const Object* FindPointable(std::string_view id) const;

  /// It came to the floor, and is out of play ever since.
  bool HasFallen(const Object& object) const { return object_states_[object.index].has_fallen; }
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

  const model::Model& model() const { return *model_; }
  const Controls& controls() const { return controls_; }
  const Bonds& bonds() const { return bonds_; }
  /// False once the object it belongs to is destroyed.
  bool IsPresent(model::ControlIndex control) const {
    return IsPresent(objects_[model_->control(control).object]);
  }

  /// See Controls::Trigger().
  [[nodiscard]] std::optional<Refusal> Trigger(std::string_view control, std::string_view part);
  /// See Bonds::Fasten() and Bonds::Loosen(). The object must be one of objects() and present.
  [[nodiscard]] std::optional<Refusal> Fasten(const Object& object, const Vector3& p_WQ);
  [[nodiscard]] std::optional<Refusal> Loosen(const Object& object, const Vector3& p_WQ);
  /// Takes the object away, with its joints, bonds and controls. It must be present.
  void Destroy(const Object& object);

  TabletopState state() const;
  /// To be called after the physics world has been restored.
  /// @param model  that the state belongs to.
  void Restore(const TabletopState& state, std::shared_ptr<const model::Model> model);
  void AddToHash(StateHash* hash) const;

  /// What can be seen of it now.
  model::SceneState scene_state() const;

 private:
  /// How much of the model is in the world already.
  struct Extent {
    std::size_t num_objects = 0, num_sliders = 0, num_chains = 0, num_guests = 0;
  };
  /// Adds what the model has beyond that.
  void AddBeyond(const Extent& extent);
  void AddBody(Object* object);
  /// The solids that are there while its controls look as they do.
  std::vector<scene::Solid> SolidsNow(const Object& object) const;
  /// Gives objects another form whose controls looked otherwise before.
  void FollowControls(const std::vector<ControlState>& before);
  bool HasPointable(const Object& object, std::string_view id) const;
  bool HasComeDown(const Object& object) const;
  /// By a hand or a gripper; or something is that it hangs on.
  bool IsHeld(const Object& object) const;

  physics::World* world_;
  std::shared_ptr<const model::Model> model_;
  physics::BodyId floor_;
  std::vector<Object> objects_;
  Controls controls_;
  std::vector<ObjectState> object_states_;  ///< one per object
  Bonds bonds_;
};

}  // namespace smile::world
