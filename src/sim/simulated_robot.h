#pragma once

#include <cstdint>
#include <memory>
#include <optional>
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
  /// Returns the reason why an arm cannot take these values; nullopt if it can or there are none.
  std::optional<Refusal> RefuseValues(const std::optional<std::vector<double>>& values,
                                      int arm) const;

  world::RobotBody body_;
  TrajectoryFollower follower_;
  bool is_shown_ = true;
  robot::FaceExpression face_expression_ = robot::FaceExpression::kIdle;
};

}  // namespace smile::sim
