#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "physics/ids.h"
#include "scene/solid.h"

class btRigidBody;

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
  ~Body();
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  BodyId id() const { return id_; }
  const BodySpec& spec() const { return *spec_; }
  bool is_static() const { return spec_->mass.mass == 0; }

  RigidTransform pose_in_world() const;  ///< X_WB
  Vector3 linear_velocity() const;       ///< v_WB of the origin [m/s]
  Vector3 angular_velocity() const;      ///< w_WB [rad/s]
  /// False when it came to rest: it costs nothing until something touches it.
  bool is_awake() const;
  /// A hand or a gripper has it: it weighs nothing (but see WeldSpec::holds_up) and never falls
  /// asleep.
  bool is_carried() const { return is_carried_; }

  /// Starts or ends being carried; both wake it and what it touches, both keep its velocity.
  /// @throws std::logic_error if the body is static.
  void SetCarried(bool is_carried);
  /// Puts the body there at once, at rest, and wakes it.
  void SetPose(const RigidTransform& X_WB);
  /// Sets v_WB [m/s] and w_WB [rad/s] and wakes the body.
  void SetVelocity(const Vector3& linear, const Vector3& angular);
  void WakeUp();

 private:
  friend class World;
  /// What hangs on a carried body, for the time being: so much mass [kg], and so much resistance to
  /// turning about any axis [kg m2], are added to its own.
  void Load(double mass, double moment);
  /// Led, it is moved by what holds it alone: nothing pushes it.
  void SetLed(bool is_led);
  /// What it has to do in the next step to be there after it; see internal_led_object.h.
  void LeadTo(const RigidTransform& X_WB, double seconds);
  void PlaceAt(const RigidTransform& X_WB);
  /// Its own mass and what hangs on it [kg].
  double loaded_mass() const { return spec_->mass.mass + load_mass_; }
  Body(BodyId id, std::shared_ptr<const BodySpec> spec);

  BodyId id_;
  /// Shared with snapshots: a spec never changes, and a snapshot may outlive the body.
  std::shared_ptr<const BodySpec> spec_;
  struct Shapes;
  std::unique_ptr<Shapes> shapes_;
  std::unique_ptr<btRigidBody> bullet_;
  Vector3 moments_;  ///< principal moments of inertia, without load
  /// From the centre of mass to the body's origin, along the world's axes [m].
  Vector3 p_BcmB_W() const;

  RigidTransform X_BcmB_;  ///< B in the frame of its centre of mass and principal axes of inertia
  bool is_carried_ = false;
  bool is_led_ = false;
  double load_mass_ = 0, load_moment_ = 0;  ///< set anew in every step
};

}  // namespace smile::physics
