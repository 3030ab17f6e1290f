#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "physics/world.h"
#include "world/controls.h"
#include "world/object.h"
#include "world/refusal.h"

namespace smile::world {

/// A plug, alive.
struct Guest {
  const scene::GuestPoint* point;  ///< belongs to the object's spec
  std::size_t object;
  RigidTransform X_BG;  ///< in the object's body B
};

/// A hole, alive.
struct Host {
  const scene::HostPoint* point;  ///< belongs to the object's spec
  std::size_t object;
  RigidTransform X_BH;                                         ///< in the object's body B
  std::optional<std::size_t> downstream, downstream_override;  ///< controls
  std::optional<std::size_t> downstream_lock;                  ///< another host
};

/// What can change about a host.
struct BondState {
  int guest = -1;  ///< index of the guest it holds; -1: none
  int tightness = 0;
  bool is_locked = false;  ///< can be neither fastened nor loosened
  physics::JointId joint;  ///< of the bond; none between two static objects

  bool operator==(const BondState&) const = default;
};

/// The bond points of a scene: which guest is fastened to which host, and how tightly.
class Bonds {
 public:
  /// All must outlive this.
  Bonds(physics::World* world, const std::vector<Object>* objects,
        const std::vector<ObjectState>* object_states, Controls* controls);
  /// Fastens what is fastened from the start. The objects must have bodies by now.
  void FastenInitially();

  const std::vector<Guest>& guests() const { return guests_; }
  const std::vector<Host>& hosts() const { return hosts_; }
  const std::vector<BondState>& states() const { return states_; }  ///< one per host
  void Restore(std::vector<BondState> states) { states_ = std::move(states); }

  /// One stage tighter: of the object's guest point nearest to `p_WQ`. A free one goes to the
  /// nearest host that fits, is free, not locked, not on the floor, less than two units away and
  /// not connected with the object already. The guest, and all that hangs on it, is put where the
  /// stage has it; the host stays.
  [[nodiscard]] std::optional<Refusal> Fasten(std::size_t object, const Vector3& p_WQ,
                                              double meters_per_unit);
  /// One stage looser; from the first stage the guest comes free.
  [[nodiscard]] std::optional<Refusal> Loosen(std::size_t object, const Vector3& p_WQ);
  /// Ends the bonds of an object that is about to be destroyed.
  void EndBondsOf(std::size_t object);

 private:
  std::optional<std::size_t> FindHost(const std::string& id) const;
  std::optional<std::size_t> HostOf(std::size_t guest) const;
  std::optional<std::size_t> NearestGuest(std::size_t object, const Vector3& p_WQ) const;
  /// The host a free guest would go to; or why there is none.
  std::optional<std::size_t> HostInReach(std::size_t guest, double reach, Refusal* refusal) const;
  /// Of each object, whether it hangs together with this one through bonds or other joints.
  std::vector<bool> ConnectedWith(std::size_t object) const;
  physics::BodyId BodyOf(const Guest& guest) const { return (*objects_)[guest.object].body; }
  physics::BodyId BodyOf(const Host& host) const { return (*objects_)[host.object].body; }
  /// The object of a body, as refusals name it.
  std::string NameOf(physics::BodyId body) const;
  RigidTransform GuestBodyAt(std::size_t guest, std::size_t host, int tightness) const;
  std::optional<Refusal> Tighten(std::size_t guest, std::size_t host, int tightness);
  void Join(std::size_t guest, std::size_t host, int tightness);
  /// Why a guest, with all that hangs on it, cannot be put there.
  std::optional<Refusal> RefuseToMove(std::size_t guest, std::size_t host,
                                      const RigidTransform& X_WB) const;
  bool IsHeldByRobot(physics::BodyId body) const;
  void TellDownstream(std::size_t host);
  bool IsInPlay(std::size_t object) const {
    return world_->Has((*objects_)[object].body) && !(*object_states_)[object].has_fallen;
  }

  physics::World* world_;
  const std::vector<Object>* objects_;
  const std::vector<ObjectState>* object_states_;
  Controls* controls_;
  std::vector<Guest> guests_;
  std::vector<Host> hosts_;
  std::vector<BondState> states_;
  std::map<std::string, std::size_t> host_of_id_;
};

}  // namespace smile::world
