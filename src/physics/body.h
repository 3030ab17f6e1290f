#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "physics/ids.h"
#include "scene/solid.h"

namespace smile::physics {

/// What a rigid body is, and where it starts.
struct BodySpec {
  std::vector<scene::Solid> solids;  ///< what it collides with, in its own frame B
  scene::MassProperties mass;        ///< mass 0 = static
  RigidTransform X_WB;               ///< where it starts
  double friction = 0.6;
  double restitution = 0.0;
  /// Keeps what rolls from rolling for ever: how far before the middle of its footprint it is
  /// supported [m]. Unset: 1 mm for all but blocks.
  std::optional<double> rolling_friction;
  /// Share of its spin lost in a second; unset: WorldConfig::damping.
  std::optional<double> angular_damping;

  bool operator==(const BodySpec&) const = default;
};

/// A rigid body of a World. Reached through World::body(); the World owns it.
class Body {
 public:
  /// Makes a body that is in no World yet; see World::AddBody().
  Body(BodyId id, std::shared_ptr<const BodySpec> spec);
  ~Body();
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  BodyId id() const { return id_; }
  const BodySpec& spec() const { return *spec_; }
  /// Shared with snapshots: a spec never changes, and a snapshot may outlive the body.
  const std::shared_ptr<const BodySpec>& shared_spec() const { return spec_; }
  bool is_static() const { return spec_->mass.mass == 0; }

  RigidTransform pose_in_world() const;  ///< X_WB
  Vector3 linear_velocity() const;       ///< v_WB of the origin [m/s]
  Vector3 angular_velocity() const;      ///< w_WB [rad/s]
  /// False when it came to rest: it costs nothing until something touches it.
  bool is_awake() const;
  /// A hand or a gripper has it: it weighs nothing (but see WeldSpec::holds_up) and never falls
  /// asleep.
  bool is_carried() const;

  /// Starts or ends being carried; both wake it and what it touches, both keep its velocity.
  /// @throws std::logic_error if the body is static.
  void SetCarried(bool is_carried);
  /// Puts the body there at once, at rest, and wakes it.
  void SetPose(const RigidTransform& X_WB);
  /// Sets v_WB [m/s] and w_WB [rad/s] and wakes the body.
  void SetVelocity(const Vector3& linear, const Vector3& angular);
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
