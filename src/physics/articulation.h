#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mechanics/joint_motors.h"
#include "physics/definitions.h"
#include "scene/articulation_spec.h"

class btCollisionObject;
class btMultiBody;

namespace smile {
class ByteReader;
class ByteWriter;
class StateHash;
}  // namespace smile

namespace smile::physics {

/// Links and motors on a fixed base, in reduced coordinates (R. Featherstone, Rigid Body Dynamics
/// Algorithms). Gravity is compensated. It collides with bodies, with other articulations and with
/// itself, unless it is kinematic; see scene::ArticulationSpec::is_kinematic. Joints never leave
/// their position limits nor exceed their velocity limits, whatever pushes them. The World owns it.
class Articulation {
 public:
  /// Makes an articulation that is not yet in a World; see World::AddArticulation().
  Articulation(ArticulationId id, std::shared_ptr<const scene::ArticulationSpec> spec,
               const MotorConfig& config);
  ~Articulation();
  Articulation(const Articulation&) = delete;
  Articulation& operator=(const Articulation&) = delete;

  ArticulationId id() const { return id_; }
  const scene::ArticulationSpec& spec() const { return *spec_; }
  /// The spec, shared with snapshots like that of a Body.
  const std::shared_ptr<const scene::ArticulationSpec>& shared_spec() const { return spec_; }
  int num_joints() const { return static_cast<int>(spec_->links.size()); }

  std::vector<double> positions() const;   ///< q, one per joint [rad or m]
  std::vector<double> velocities() const;  ///< v, one per joint [rad/s or m/s]
  std::span<const double> velocity_targets() const { return motors_.velocity_targets(); }
  std::vector<RigidTransform> link_poses() const;  ///< X_WL, one per link

  /// Moves a joint, and those that mimic it, at this speed until the next command [rad/s or m/s].
  /// Clamped to the joint's velocity limit; at a position limit the joint stops. If the joint is
  /// blocked and is commanded to stop or to reverse, it does so at once: the lead of its reference
  /// is dropped.
  /// @throws std::invalid_argument if there is no such joint, it mimics another one, or the
  ///         velocity is not finite.
  void SetVelocityTarget(int joint, double velocity);
  /// Stops a joint at its present position and drops the lead of its reference.
  void HoldStill(int joint);
  /// Puts these joints at positions [rad or m] at once, at rest, clamped to their limits; joints
  /// that mimic others go where their leaders are. The others keep their motion. Nearby bodies
  /// react only if they are awake: see World::WakeAll().
  /// @throws std::invalid_argument if the counts differ, a joint does not exist or a value is not
  ///         finite.
  void SetPositions(std::span<const int> joints, std::span<const double> positions);

  /// Returns true if no velocity is commanded and no joint moves.
  bool is_at_rest() const;

  /// Bullet's side of the articulation, for this room; see internal_articulation_links.h.
  struct Links;
  const Links& links() const { return *links_; }

 private:
  friend class HeldBodies;
  friend class World;
  friend class WorldObjects;
  void MakeTrees();
  void AddBulletLink(int link);
  void MakeColliders();
  /// Makes the collision object of a link, or of the base (-1).
  std::unique_ptr<btCollisionObject> MakeCollider(int link);
  /// Brings Bullet's own copies of the link poses up to date with q.
  void UpdateLinkTransforms();
  /// Called once before each physics step.
  void BeforeStep(double step_seconds, double gravity);
  /// Reports an overload on this link: in the next step, the motors that bear it have only the
  /// listed effort.
  void NoteOverload(int link) { motors_.NoteOverload(link); }
  /// Advances the references and commands the motors.
  void DriveMotors(double step_seconds, double gravity);
  /// Sets the velocities of kinematic links, and the references to the joint positions after the
  /// step.
  void DriveKinematicLinks(double step_seconds);
  /// Called once after each physics step: a kinematic articulation arrives at its references.
  void AfterStep();
  /// X_WL of each link of a kinematic articulation after the next step.
  std::vector<RigidTransform> next_link_poses() const;
  void Save(ByteWriter* out) const;
  void Restore(ByteReader* in);
  void AddTo(StateHash* hash) const;

  ArticulationId id_;
  std::shared_ptr<const scene::ArticulationSpec> spec_;
  mechanics::JointMotors motors_;
  std::unique_ptr<Links> links_;
};

}  // namespace smile::physics
