#pragma once

#include "base/bytes.h"
#include "base/state_hash.h"
#include "math/principal_inertia.h"
#include "physics/body.h"
#include "physics/internal_collision_object.h"
#include "physics/internal_shapes.h"

namespace smile::physics {

class DormantIslands;

/// Bullet's part of a Body: its state of motion, and what moves it. Bullet moves each body at its
/// center of mass along its principal axes (frame Bcm).
class Body::Dynamics {
 public:
  Dynamics(BodyId id, const BodySpec& spec);
  Dynamics(const Dynamics&) = delete;
  Dynamics& operator=(const Dynamics&) = delete;

  btRigidBody& bullet() { return bullet_; }
  const btRigidBody& bullet() const { return bullet_; }
  const RigidTransform& X_BcmB() const { return X_BcmB_; }
  /// Returns the vector from the center of mass to the body's origin, along the world's axes [m].
  Vector3 p_BcmB_W() const;

  /// Place among the bodies of a World, by id.
  std::size_t place() const { return place_; }
  void set_place(std::size_t place) { place_ = place; }

  bool is_carried() const { return is_carried_; }
  void set_is_carried(bool is_carried) { is_carried_ = is_carried; }

  /// Adds mass [kg] and moment of inertia about each axis [kg m2] to the body's own, for what hangs
  /// on it while it is carried.
  void Load(double mass, double moment);
  /// Returns its own mass plus the load [kg].
  double loaded_mass() const { return mass_ + load_mass_; }

  bool is_kinematic() const { return is_kinematic_; }
  /// Makes the body kinematic, or dynamic again. A kinematic body follows its holder; nothing else
  /// pushes it.
  void SetKinematic(bool is_kinematic);
  /// Gives a kinematic body the velocity that brings it to `X_WB` in `seconds`.
  void SetVelocityToReach(const RigidTransform& X_WB, double seconds);
  /// Moves a kinematic body to `X_WB`; it keeps its velocity.
  void SetPose(const RigidTransform& X_WB);

  /// Returns the state that was kept, while it is still the body's state; otherwise null.
  const std::shared_ptr<const std::vector<std::byte>>& known_state() const;
  /// Keeps the present state, with the body's contacts, until something happens to the body.
  void KeepState(std::shared_ptr<const std::vector<std::byte>> state);
  void Save(ByteWriter* out) const;
  void Restore(ByteReader* in);

  /// Sets the islands among which that of the body may be.
  void set_dormant_islands(DormantIslands* islands) { dormant_islands_ = islands; }
  /// Returns the body's island to Bullet's world if it was left out.
  void ReturnToWorld();

 private:
  Dynamics(BodyId id, const BodySpec& spec, const PrincipalInertia& inertia);
  void UpdateMass();

  double mass_;
  Vector3 moments_;        ///< principal moments of inertia, without load
  RigidTransform X_BcmB_;  ///< B in the frame of its center of mass and principal axes of inertia
  CollisionShape collision_;
  btRigidBody bullet_;
  std::size_t place_ = 0;
  bool is_carried_ = false;
  bool is_kinematic_ = false;
  double load_mass_ = 0, load_moment_ = 0;  ///< set in each step
  DormantIslands* dormant_islands_ = nullptr;
  std::int64_t known_period_ = 0;  ///< of known_state_; see DormantIslands::PeriodOf()
  std::shared_ptr<const std::vector<std::byte>> known_state_;
};

}  // namespace smile::physics
