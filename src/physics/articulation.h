#pragma once

#include <memory>
#include <span>
#include <vector>

#include "physics/articulation_spec.h"
#include "physics/ids.h"

class btMultiBody;

namespace smile::physics {

/// How joint motors follow their targets; measured values, see docs/decisions/physics.md.
struct MotorConfig {
  /// Share of the position error that is taken back in every physics step.
  double position_gain = 0.1;
  /// The reference never runs farther ahead of the joint than this: a blocked arm stays gentle and
  /// resumes without a jump.
  double max_lead_angle = 0.05;    ///< of a turning joint [rad]
  double max_lead_length = 0.002;  ///< of a sliding one [m]
  /// Motors may use this multiple of the listed effort: velocity commands arrive without
  /// acceleration limits, which the real controller would smooth.
  double effort_scale = 4.0;

  bool operator==(const MotorConfig&) const = default;
};

/// Links and motors on a fixed base, in reduced coordinates (Featherstone). Gravity is compensated.
/// It collides with bodies, with other articulations and with itself. The World owns it.
class Articulation {
 public:
  ~Articulation();
  Articulation(const Articulation&) = delete;
  Articulation& operator=(const Articulation&) = delete;

  ArticulationId id() const { return id_; }
  const ArticulationSpec& spec() const { return *spec_; }
  int num_joints() const { return static_cast<int>(spec_->links.size()); }

  std::vector<double> positions() const;   ///< q, one per joint [rad or m]
  std::vector<double> velocities() const;  ///< v, one per joint [rad/s or m/s]
  std::span<const double> velocity_targets() const { return velocity_targets_; }
  std::vector<RigidTransform> link_poses() const;  ///< X_WL, one per link

  /// Keeps moving a joint at this speed until told otherwise [rad/s or m/s]. Clamped to the joint's
  /// velocity limit; at a position limit the joint stops.
  /// @throws std::invalid_argument if there is no such joint or the velocity is not finite.
  void SetVelocityTarget(int joint, double velocity);
  /// Stops a joint where it is now, forgetting how far its reference had run ahead.
  void HoldStill(int joint);
  /// Puts these joints there at once, at rest, clamped to their limits; the others go on. Bodies
  /// near by notice only if they are awake: see World::WakeAll().
  /// @throws std::invalid_argument if the counts differ, a joint does not exist or a value is not
  /// finite.
  void SetPositions(std::span<const int> joints, std::span<const double> positions);

  /// True when nothing is commanded and nothing moves.
  bool is_at_rest() const;

 private:
  friend class World;
  Articulation(ArticulationId id, std::shared_ptr<const ArticulationSpec> spec,
               const MotorConfig& config);
  void CheckJoint(int joint) const;
  /// Brings Bullet's own copies of the link poses up to date with q.
  void UpdateLinkTransforms();
  /// Moves references on and commands the motors; once before each physics step.
  void DriveMotors(double step_seconds, double gravity);

  ArticulationId id_;
  std::shared_ptr<const ArticulationSpec> spec_;  ///< shared with snapshots, like Body's
  MotorConfig config_;
  std::vector<double> velocity_targets_;
  std::vector<double> position_references_;
  struct Links;
  std::unique_ptr<Links> links_;
  std::unique_ptr<btMultiBody> bullet_;
};

}  // namespace smile::physics
