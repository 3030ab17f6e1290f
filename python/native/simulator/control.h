#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/arm_kinematics.h"
#include "sim/simulation.h"

namespace smile::python {

/// What the numbers of an action command.
enum class ControlKind { kJointVelocities, kJointPositions, kEndEffector, kWaypoints };

struct ControlOptions {
  ControlKind kind = ControlKind::kJointVelocities;
  std::vector<std::string> arms;  ///< names; empty: all
  int ticks = 6;                  ///< per action, except waypoints
  double speed = 0.5;             ///< fraction of the joints' limits of velocity
  double displacement = 0.05;     ///< of an end effector per action, along each axis [m]
  double rotation = 0.2;          ///< the same about each axis [rad]
  Vector3 lowest{-0.5, -0.5, 0};  ///< corners of the box of waypoints, in the world [m]
  Vector3 highest{0.5, 0.5, 0.5};
};

/// Control of a robot by actions: lists of numbers from -1 to 1, arm after arm. The last number of
/// an arm with a gripper is its rate of opening, a fraction of the greatest; between -0.1 and 0.1
/// the gripper stays as it is.
///
/// joint velocities   one per joint, a fraction of `speed` times its limit
/// joint positions    one per joint, from its lower to its upper limit, as goal of the action
/// end effector       displacement along x, y, z of the world, rotation about these axes
/// waypoints          x, y, z within the box, yaw from -pi to pi, of the tool pointing down: the
///                    action lasts until it is there, then the gripper moves for half a second
///
/// It has no state: what an action does depends on the simulation only.
class Control {
 public:
  /// @throws std::invalid_argument if there is no robot or no such arm.
  Control(std::shared_ptr<const model::Model> model, ControlOptions options);

  /// Names of an action's numbers, `left.left_s0` for example.
  const std::vector<std::string>& names() const { return names_; }
  /// Indices of the controlled arms.
  std::vector<int> arms() const;

  /// Carries out an action, to its end.
  /// @param action  finite, clipped to [-1, 1].
  /// @returns the reason if a part of it was impossible, as a waypoint out of reach.
  /// @throws std::invalid_argument if it has another size or is not finite.
  std::optional<std::string> Perform(std::span<const double> action,
                                     sim::Simulation* simulation) const;

 private:
  struct ControlledArm {
    int index;
    std::string name;
    motion::ArmKinematics kinematics;
    double opening_speed = 0;  ///< [m/s]; 0 without a gripper
    bool has_gripper = false;
    std::size_t first = 0;    ///< of its numbers in an action
    std::size_t gripper = 0;  ///< index of the gripper's number
  };

  std::vector<std::string> NumbersOf(const ControlledArm& arm) const;
  /// Returns the velocities of an arm's joints for a tick [rad/s].
  /// @param ticks_left  of the action, with this one.
  std::vector<double> VelocitiesFor(const ControlledArm& arm, std::span<const double> numbers,
                                    const world::RobotBody& robot, const RigidTransform& X_WG_start,
                                    int ticks_left) const;
  std::vector<double> TowardsPositions(const ControlledArm& arm, std::span<const double> numbers,
                                       const world::RobotBody& robot, int ticks_left) const;
  std::vector<double> TowardsPose(const ControlledArm& arm, const RigidTransform& X_WG_goal,
                                  const world::RobotBody& robot, int ticks_left) const;
  std::optional<std::string> MoveToWaypoints(std::span<const double> action,
                                             sim::Simulation* simulation) const;
  /// Starts the motion of an arm to its waypoint.
  std::optional<std::string> StartToWaypoint(const ControlledArm& arm,
                                             std::span<const double> numbers,
                                             sim::Simulation* simulation) const;
  /// Returns the rates of the grippers that an action moves [m/s].
  sim::ByArm<double> GripperRates(std::span<const double> action, bool keeps_still) const;

  std::shared_ptr<const model::Model> model_;
  ControlOptions options_;
  std::vector<ControlledArm> arms_;
  std::vector<std::string> names_;
};

}  // namespace smile::python
