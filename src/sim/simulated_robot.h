#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "robot/face_expression.h"
#include "sim/command.h"
#include "sim/trajectory_follower.h"
#include "world/robot_body.h"

namespace smile::sim {

/// State of a robot apart from its bodies, whose state is part of the physics world.
struct SimulatedRobotState {
  world::RobotBodyState body;
  FollowerState follower;
  bool is_shown = true;
  robot::FaceExpression face_expression = robot::FaceExpression::kIdle;
};

/// Returns the command that stops a robot: all arms, grippers and its head.
JointVelocities StillVelocities(const robot::RobotModel& model);

/// Robot of a simulation: its body, the trajectories it follows, and its appearance.
class SimulatedRobot {
 public:
  /// Adds the model's robot to `world`, which must outlive this.
  SimulatedRobot(physics::World* world, std::shared_ptr<const model::Model> model);
  SimulatedRobot(const SimulatedRobot&) = delete;
  SimulatedRobot& operator=(const SimulatedRobot&) = delete;

  /// Execute a command, at `tick` if it begins a motion.
  /// @returns the reason if it was refused; the robot has then not changed.
  std::optional<Refusal> Execute(const JointVelocities& velocities);
  std::optional<Refusal> Execute(const JointAngles& angles);
  std::optional<Refusal> Execute(const TurnJoint& turn);
  std::optional<Refusal> Execute(const MoveGripper& move);
  std::optional<Refusal> Execute(const TakePose& pose, std::uint64_t tick);
  std::optional<Refusal> Execute(const FollowTrajectory& follow, std::uint64_t tick);
  std::optional<Refusal> Execute(const ShowRobot& show);
  std::optional<Refusal> Execute(const Face& face);

  /// Call before the physics steps of a tick, and after each of them.
  void BeforeTick(std::uint64_t tick) { follower_.BeforeTick(tick); }
  void AfterStep() { body_.AfterStep(); }

  const world::RobotBody& body() const { return body_; }
  /// Returns true while joints move to a pose or along a trajectory.
  bool is_following() const { return follower_.is_following(); }
  bool is_shown() const { return is_shown_; }
  robot::FaceExpression face_expression() const { return face_expression_; }

  SimulatedRobotState Save() const;
  void Restore(const SimulatedRobotState& state);
  void AddToHash(StateHash* hash) const;

 private:
  /// End the following of trajectories by joints that get another command.
  void StopFollowingWithArm(int arm);
  void StopFollowingWithGripper(int arm);
  void StopFollowingWithHead();
  /// Returns the index of an arm, named as in ByArm; nullopt without such an arm.
  std::optional<int> FindArm(std::string_view name) const;
  /// The same for an arm with a gripper.
  std::optional<int> FindGripper(std::string_view name) const;
  /// Return the reason why arms or grippers cannot take these values; nullopt if they can.
  std::optional<Refusal> RefuseValues(const ByArm<std::vector<double>>& values) const;
  std::optional<Refusal> RefuseRates(const ByArm<double>& rates) const;
  Refusal NoSuchArm(std::string_view name) const;
  /// Moves the gripper of an arm.
  void SetGripper(int arm, double velocity);

  world::RobotBody body_;
  TrajectoryFollower follower_;
  bool is_shown_ = true;
  robot::FaceExpression face_expression_ = robot::FaceExpression::kIdle;
};

}  // namespace smile::sim
