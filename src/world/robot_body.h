#pragma once

#include <memory>
#include <span>
#include <vector>

#include "model/model.h"
#include "physics/world.h"

namespace smile::world {

/// What one gripper was told, and what it holds.
struct GripperState {
  double opening_velocity = 0;          ///< > 0 opens [m/s]
  std::vector<physics::JointId> welds;  ///< to the bodies it holds

  bool operator==(const GripperState&) const = default;
};

/// What a RobotBody remembers beside its articulation; part of every saved state.
struct RobotBodyState {
  std::vector<GripperState> grippers;  ///< one per arm

  bool operator==(const RobotBodyState&) const = default;
};

/// A robot that stands in a physics World and does what it is told.
///
/// Arms and head keep a commanded velocity until the next one. A gripper that closes on a body
/// holds it (see GraspedBodies()) and keeps its opening until it is told to open; one that grasps
/// by friction goes on closing, with the effort of one finger.
class RobotBody {
 public:
  /// Adds the model's robot to `world`, which must outlive this, in its start configuration.
  /// @throws std::invalid_argument if there is none, or the options of its body exclude each other.
  RobotBody(physics::World* world, std::shared_ptr<const model::Model> model);

  const robot::RobotModel& model() const { return *model_->robot(); }
  int num_arms() const { return static_cast<int>(model().arms.size()); }

  /// @param velocities  one per joint of the arm [rad/s]; clamped to the joints' limits.
  /// @throws std::invalid_argument if the count is wrong or one is not finite.
  void SetArmVelocities(int arm, std::span<const double> velocities);
  /// @param velocity  rate of change of the opening [m/s]; any positive one lets go of what is
  /// held.
  void SetGripperVelocity(int arm, double velocity);
  /// Of one joint, whichever, but not of a finger, which its gripper moves [rad/s or m/s]; clamped
  /// to its limits.
  /// @throws std::invalid_argument if there is no such joint or the velocity is not finite.
  void SetJointVelocity(int joint, double velocity);
  /// @param velocity  of the head's pan [rad/s].
  void SetHeadVelocity(double velocity);
  /// Puts an arm there at once, with what is attached to it [rad]; clamped to the limits.
  void SetArmAngles(int arm, std::span<const double> angles);
  void SetHeadAngle(double angle);

  /// To be called after each physics step: looks whether a closing gripper has got something.
  void AfterStep();

  std::vector<double> ArmAngles(int arm) const;      ///< [rad]
  std::vector<double> ArmVelocities(int arm) const;  ///< [rad/s]
  double HeadAngle() const;                          ///< [rad]; 0 without a head
  double GripperOpening(int arm) const;              ///< [m]; 0 without a gripper
  RigidTransform ToolPose(int arm) const;            ///< X_WG, between the fingers
  /// Those attached to the gripper; none where friction holds.
  std::vector<physics::BodyId> HeldBodies(int arm) const;
  /// True when a link touches one of these.
  bool IsTouching(const std::vector<physics::BodyId>& bodies) const;
  std::vector<double> positions() const;  ///< q of all joints, as in model()
  const RigidTransform& base_pose() const { return model_->robot_base_pose(); }

  const RobotBodyState& state() const { return state_; }
  void Restore(const RobotBodyState& state) { state_ = state; }

 private:
  physics::Articulation& articulation() { return world_->articulation(articulation_); }
  const physics::Articulation& articulation() const { return world_->articulation(articulation_); }
  void CloseAround(int arm);
  void LetGo(int arm);
  void CommandFingers(int arm);
  /// True when some body touches both fingers.
  bool IsSqueezing(const robot::Gripper& gripper) const;
  const model::RobotBodyOptions& options() const { return model_->robot_placement()->body; }

  physics::World* world_;
  std::shared_ptr<const model::Model> model_;
  physics::ArticulationId articulation_;
  RobotBodyState state_;
};

}  // namespace smile::world
