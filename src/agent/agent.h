#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "agent/fields.h"

/// A robot program's side of the conversation with the simulator: docs/brains.md has an example.
namespace smile::agent {

/// What a program is told once, and what it may wish.
struct Aux : Fields {
  using Fields::Fields;

  std::optional<Eigen::MatrixXd> init_joint_angles;  ///< in Init(): limbs x joints [rad]
  std::vector<std::string> channels;                 ///< in Init(): `rgb`, `depth`, `segmentation`
  std::vector<std::string> cameras;                  ///< in Init(): beside the robot's eye
  std::optional<double> image_seconds;               ///< in Init(): between fresh images
  bool watch = false;                            ///< in Init(): be shown the demonstration first
  std::optional<Eigen::MatrixX3d> draw_markers;  ///< at any time: points for people [units]
  bool exit = false;                             ///< the step that has set it is the last
};

/// What a program is told at every step.
using Sensor = Fields;

/// What the robot shall do. Keeps its values until they are changed.
struct Motor {
  Eigen::MatrixXd joint_velocities;             ///< limbs x joints [rad/s]
  Eigen::VectorXd gripper_velocities;           ///< for each limb [units/s]
  std::optional<Eigen::MatrixXd> joint_angles;  ///< be there at once [rad]
  std::optional<double> head_velocity;          ///< [rad/s]
};

/// A robot program. An exception that leaves its functions ends it with that message.
class Program {
 public:
  virtual ~Program() = default;
  /// Once, before the first step.
  virtual void Init(Aux& /*aux*/) {}
  virtual void Step(const Sensor& sensor, Motor& motor, Aux& aux) = 0;
};

/// Meets the simulator that started this process and runs the program until the simulator says
/// goodbye.
/// @returns what main() returns: 0, or 1 after saying on stderr what went wrong.
int Run(Program& program);

}  // namespace smile::agent
