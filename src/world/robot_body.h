#pragma once

#include <memory>
#include <span>
#include <vector>

#include "model/model.h"
#include "physics/world.h"

namespace smile::world {

/// Command and held bodies of one gripper.
struct GripperState {
  double opening_velocity = 0;          ///< > 0 opens [m/s]
  std::vector<physics::JointId> welds;  ///< to the bodies it holds

  bool operator==(const GripperState&) const = default;
};

/// State of a RobotBody beside its articulation; part of each saved state.
struct RobotBodyState {
  std::vector<GripperState> grippers;  ///< one per arm

  bool operator==(const RobotBodyState&) const = default;
};

/// A robot in a physics World that executes commands.
///
/// Arms and head keep a commanded velocity until the next one. A gripper that closes on a body
/// holds it (see world/grasp_rule.h) and keeps its opening until it is commanded to open; one that
/// grasps by friction continues to close, with the effort of one finger. A suction cup that is
/// commanded to close holds the first body that it touches.
class RobotBody {
 public:
  /// Adds the model's robot to `world`, which must outlive this, in its start configuration.
  /// @throws std::invalid_argument if it has none, or the options of its body exclude each other.
  RobotBody(physics::World* world, std::shared_ptr<const model::Model> model);

  const robot::RobotModel& model() const { return *model_->robot(); }
  int num_arms() const { return static_cast<int>(model().arms.size()); }

  /// Sets the velocities of an arm's joints.
  /// @param velocities  one per joint of the arm [rad/s]; clamped to the joints' limits.
  /// @throws std::invalid_argument if the count is wrong or one is not finite.
  void SetArmVelocities(int arm, std::span<const double> velocities);
  /// Sets the velocity of a gripper.
  /// @param velocity  rate of change of the opening [m/s]; a positive one releases what is held.
  void SetGripperVelocity(int arm, double velocity);
  /// Sets the velocity of any joint except those that a gripper or another joint moves [rad/s or
  /// m/s]; clamped to its limits.
  /// @throws std::invalid_argument if there is no such joint or the velocity is not finite.
  void SetJointVelocity(int joint, double velocity);
  /// Sets the velocity of the head's pan [rad/s].
  void SetHeadVelocity(double velocity);
  /// Puts an arm at these angles [rad] at once, with the bodies it holds; clamped to the limits.
  void SetArmAngles(int arm, std::span<const double> angles);
  void SetHeadAngle(double angle);

  /// Call after each physics step: checks whether a closing gripper has grasped a body.
  void AfterStep();

  std::vector<double> ArmAngles(int arm) const;      ///< [rad]
  std::vector<double> ArmVelocities(int arm) const;  ///< [rad/s]
  double HeadAngle() const;                          ///< [rad]; 0 without a head
  double GripperOpening(int arm) const;    ///< [m]; 0 without a gripper and of a suction cup
  RigidTransform ToolPose(int arm) const;  ///< X_WG, between the fingers
  /// Returns the bodies attached to the gripper; none if it holds by friction.
  std::vector<physics::BodyId> HeldBodies(int arm) const;
  /// Returns true if a link touches one of these bodies.
  bool IsTouching(const std::vector<physics::BodyId>& bodies) const;
  std::vector<double> positions() const;  ///< q of all joints, as in model()
  const RigidTransform& base_pose() const { return model_->robot_base_pose(); }

  const RobotBodyState& state() const { return state_; }
  void Restore(const RobotBodyState& state) { state_ = state; }

 private:
  physics::Articulation& articulation() { return world_->articulation(articulation_); }
  const physics::Articulation& articulation() const { return world_->articulation(articulation_); }
  /// Attaches what a closing gripper has grasped.
  void CloseAround(int arm);
  /// Returns the bodies that a closing gripper has grasped.
  std::vector<physics::BodyId> BodiesIn(int arm) const;
  /// Returns the links that may overlap a body which the gripper holds.
  std::vector<int> LinksAroundHeld(int arm) const;
  void Release(int arm);
  /// Commands the joints of a gripper.
  void CommandGripper(int arm);
  void CommandFingers(int arm);
  void CommandDrive(int arm);
  /// Returns true if a body touches both fingers.
  bool IsSqueezing(const robot::Gripper& gripper) const;
  bool GraspsByFriction(const robot::Gripper& gripper) const;
  const model::RobotBodyOptions& options() const { return model_->robot_placement()->body; }

  physics::World* world_;
  std::shared_ptr<const model::Model> model_;
  physics::ArticulationId articulation_;
  RobotBodyState state_;
};

}  // namespace smile::world
