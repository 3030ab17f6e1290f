#pragma once

#include <optional>
#include <vector>

#include "physics/world.h"
#include "world/controls.h"
#include "world/object.h"
#include "world/object_states.h"
#include "world/refusal.h"

namespace smile::world {

using model::GuestIndex;
using model::HostIndex;
using model::ObjectIndex;

/// State of a host.
struct BondState : model::HostState {
  physics::JointId joint;  ///< joint of the bond; none between two static objects

  bool operator==(const BondState&) const = default;
};

/// Change of a guest to its next stage.
struct GuestTurn {
  GuestIndex guest{0};
  HostIndex host{0};
  int tightness = 0;       ///< from then on; 0: free
  physics::BodyId tool{};  ///< by which; it may be in the way of the guest. None: a bare hand
};

/// Bond points of a scene: which guest is fastened to which host, and how tightly.
class Bonds {
 public:
  /// All must outlive this.
  Bonds(physics::World* world, const model::Model& model, const std::vector<Object>* objects,
        const ObjectStates* object_states, Controls* controls);
  /// Adds the hosts that a larger model has behind the present ones, empty.
  /// @param model  must outlive this, as the one of Restore().
  void Grow(const model::Model& model);
  /// Fastens the guests from `first` on that are fastened from the start. Their objects must
  /// already have bodies.
  void FastenInitially(GuestIndex first);

  const std::vector<BondState>& states() const { return states_; }  ///< by HostIndex
  void Restore(std::vector<BondState> states, const model::Model& model);

  /// Returns how a tool would turn a guest by one stage now, or nullopt with the reason in
  /// `refusal`. A tool may turn a guest that refuses hands.
  /// @param direction  1: tightens, -1: loosens.
  std::optional<GuestTurn> PlanTurn(GuestIndex guest, int direction, physics::BodyId tool,
                                    Refusal* refusal) const;
  /// Turns a guest as planned in the present state. The guest and its assembly move to the place of
  /// the stage; the host stays.
  void Turn(const GuestTurn& turn);
  /// Ends the bond of a host at once, as when it is cut: guest and host pass through each other
  /// until they have separated.
  void End(HostIndex host);
  /// Returns the host that a guest is fastened to.
  std::optional<HostIndex> HostOf(GuestIndex guest) const;

  /// Tightens the object's guest point nearest to `p_WQ` by one stage. A free guest goes to the
  /// nearest host that fits, is free, not locked, not on the floor, less than two units away and
  /// not already connected with the object.
  [[nodiscard]] std::optional<Refusal> Fasten(ObjectIndex object, const Vector3& p_WQ);
  /// Loosens a guest by one stage; from the first stage it comes free.
  [[nodiscard]] std::optional<Refusal> Loosen(ObjectIndex object, const Vector3& p_WQ);
  /// Ends the bonds of an object that is about to be destroyed.
  void EndBondsOf(ObjectIndex object);

 private:
  /// Returns the reason why hands cannot turn a guest.
  std::optional<Refusal> RefuseHands(GuestIndex guest) const;
  /// Returns the next stage of a guest, whether or not there is room for it.
  std::optional<GuestTurn> NextStage(GuestIndex guest, int direction, Refusal* refusal) const;
  /// Turns a guest by a bare hand, or returns the reason why not.
  std::optional<Refusal> TurnByHand(GuestIndex guest, int direction);
  std::optional<GuestIndex> NearestGuest(ObjectIndex object, const Vector3& p_WQ) const;
  /// Returns the host that a free guest would go to, or nullopt with the reason in `refusal`.
  std::optional<HostIndex> HostInReach(GuestIndex guest, double reach, Refusal* refusal) const;
  /// Returns for each object whether it is connected with this one through bonds or other joints.
  std::vector<bool> ConnectedWith(ObjectIndex object) const;
  physics::BodyId BodyOf(GuestIndex guest) const {
    return (*objects_)[model_->guest(guest).object].body;
  }
  physics::BodyId BodyOf(HostIndex host) const {
    return (*objects_)[model_->host(host).object].body;
  }
  /// Returns the name of a body's object for refusals.
  Refusal NameOf(physics::BodyId body) const;
  RigidTransform GuestBodyAt(GuestIndex guest, HostIndex host, int tightness) const;
  void Join(GuestIndex guest, HostIndex host, int tightness);
  /// Returns the reason why a guest and its assembly cannot be put at `X_WB`.
  /// @param tool  does not count as an obstacle.
  std::optional<Refusal> RefuseToMove(GuestIndex guest, HostIndex host, const RigidTransform& X_WB,
                                      physics::BodyId tool) const;
  bool IsHeldByRobot(physics::BodyId body) const;
  void NotifyDownstream(HostIndex host);
  bool IsInPlay(ObjectIndex object) const {
    return world_->Has((*objects_)[object].body) && !(*object_states_)[object].has_fallen;
  }

  physics::World* world_;
  const model::Model* model_;
  const std::vector<Object>* objects_;
  const ObjectStates* object_states_;
  Controls* controls_;
  std::vector<BondState> states_;
};

}  // namespace smile::world
