#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mechanics/world_config.h"
#include "scene/articulation_spec.h"

namespace smile {
class ByteReader;
class ByteWriter;
class StateHash;
}  // namespace smile

namespace smile::mechanics {

/// Target of the drive of one joint in one step.
struct DriveTarget {
  /// Velocity at the end of the step [rad/s or m/s]; of a coupling: beyond that of its leader.
  double velocity = 0;
  double max_impulse = 0;  ///< of a motor [N m s or N s]; couplings do not use it
};

/// Motors and couplings of an articulation, as numbers. Each motor moves a position reference with
/// its velocity target; the joint follows it. Positions `q` are one per joint [rad or m].
class JointMotors {
 public:
  JointMotors(std::shared_ptr<const scene::ArticulationSpec> spec, const MotorConfig& config);

  std::span<const double> velocity_targets() const { return velocity_targets_; }
  /// One per joint [rad or m].
  std::span<const double> position_references() const { return position_references_; }

  /// Sets the velocity target of a joint [rad/s or m/s], clamped to its velocity limit. Drops the
  /// lead of a blocked joint that is commanded to stop or to reverse.
  /// @throws std::invalid_argument if there is no such joint, it mimics another one, or the
  ///         velocity is not finite.
  void SetVelocityTarget(int joint, double velocity, std::span<const double> q);
  /// Stops a joint at its present position and drops the lead of its reference.
  /// @throws std::invalid_argument if there is no such joint.
  void HoldStill(int joint, std::span<const double> q);
  /// Puts joints at these positions [rad or m], clamped to their limits, in `q` and in their
  /// references, and joints that mimic them where their leaders are. Returns the moved joints.
  /// @throws std::invalid_argument if the counts differ, a joint does not exist or a value is not
  ///         finite.
  std::vector<int> Place(std::span<const int> joints, std::span<const double> positions,
                         std::span<double> q);

  /// Returns true if no velocity is commanded, no joint moves at its velocity `v` [rad/s or m/s],
  /// and each is at its reference.
  bool is_at_rest(std::span<const double> q, std::span<const double> v) const;

  /// Reports an overload on this link: in the next step, the motors that bear it have only the
  /// listed effort.
  void NoteOverload(int link);
  /// Advances the references by one step, and computes the target of each drive.
  std::vector<DriveTarget> Drive(std::span<const double> q, double step_seconds);
  /// Sets the references to the positions after the next step of a kinematic articulation.
  void AdvanceKinematic(std::span<const double> q, double step_seconds);

  void Save(int joint, ByteWriter* out) const;
  void Restore(int joint, ByteReader* in);
  void AddTo(StateHash* hash) const;

 private:
  void CheckJoint(int joint) const;
  double MaxLead(int joint) const;
  DriveTarget DriveMotor(int joint, double q, double step_seconds);
  DriveTarget DriveCoupling(int joint, std::span<const double> q, double step_seconds);
  int num_joints() const { return static_cast<int>(spec_->links.size()); }

  /// Shared with the Articulation, whose definition does not change.
  std::shared_ptr<const scene::ArticulationSpec> spec_;
  MotorConfig config_;
  std::vector<double> velocity_targets_;
  std::vector<double> position_references_;
  std::vector<bool> is_overloaded_;  ///< for one step
};

}  // namespace smile::mechanics
