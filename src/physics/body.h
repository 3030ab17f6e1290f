#pragma once

#include <memory>

#include "physics/definitions.h"

namespace smile::physics {

/// Rigid body of a World, which owns it. See World::body().
class Body {
 public:
  /// Makes a body that is not yet in a World; see World::AddBody().
  Body(BodyId id, std::shared_ptr<const BodySpec> spec);
  ~Body();
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  BodyId id() const { return id_; }
  const BodySpec& spec() const { return *spec_; }
  /// The spec, shared with snapshots: it never changes, and a snapshot may outlive the body.
  const std::shared_ptr<const BodySpec>& shared_spec() const { return spec_; }
  bool is_static() const { return spec_->mass.mass == 0; }

  RigidTransform pose_in_world() const;  ///< X_WB
  Vector3 linear_velocity() const;       ///< v_WB of the origin [m/s]
  Vector3 angular_velocity() const;      ///< w_WB [rad/s]
  /// False after it came to rest: it then costs nothing until something touches it.
  bool is_awake() const;
  /// True while a hand or a gripper holds it: it weighs nothing (but see WeldSpec::holds_up) and
  /// never falls asleep.
  bool is_carried() const;

  /// Marks the body as carried or no longer carried; either way it wakes, as does everything it
  /// touches, and keeps its velocity.
  /// @throws std::logic_error if the body is static.
  void SetCarried(bool is_carried);
  /// Puts the body at `X_WB` at once, at rest, and wakes it.
  void SetPose(const RigidTransform& X_WB);
  /// Sets v_WB [m/s] and w_WB [rad/s] and wakes the body.
  void SetVelocity(const Vector3& linear, const Vector3& angular);
  /// Wakes the body unless it is static; restarts the time it must rest before it falls asleep.
  void WakeUp();

  /// Bullet's side of the body, for this room; see internal_body_dynamics.h.
  class Dynamics;
  Dynamics& dynamics() { return *dynamics_; }
  const Dynamics& dynamics() const { return *dynamics_; }

 private:
  BodyId id_;
  std::shared_ptr<const BodySpec> spec_;
  std::unique_ptr<Dynamics> dynamics_;
};

}  // namespace smile::physics
