#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "brain_client/fields.h"

/// A brain's side of the protocol with the simulator. docs/brains.md has an example.
namespace smile::brain_client {

/// What the simulator describes once, and the settings that a brain may change.
struct Aux : Fields {
  using Fields::Fields;

  std::optional<Eigen::MatrixXd> init_joint_angles;  ///< in Init(): limbs x joints [rad]
  std::vector<std::string> channels;                 ///< in Init(): `rgb`, `depth`, `segmentation`
  std::vector<std::string> cameras;                  ///< in Init(): besides the robot's eye
  std::optional<double> image_seconds;               ///< at any time: between images [s]
  bool watch = false;                                ///< in Init(): watch the demonstration first
  std::optional<Eigen::MatrixX3d> draw_markers;      ///< at any time: points to show [units]
  bool exit = false;                                 ///< ends the brain after the step that sets it
};

/// Inputs of a step.
using Sensor = Fields;

/// Outputs of a step. Each keeps its value until the brain changes it.
///
/// Velocities may be those of N successive ticks, one block after the other: joint_velocities then
/// is limbs x (joints * N), gripper_velocities has limbs * N numbers.
struct Motor {
  Eigen::MatrixXd joint_velocities;             ///< limbs x joints [rad/s]
  Eigen::VectorXd gripper_velocities;           ///< for each limb [units/s]
  std::optional<Eigen::MatrixXd> joint_angles;  ///< sets the joints at once [rad]
  std::optional<double> head_velocity;          ///< [rad/s]
  std::optional<int> ticks;  ///< until the next step; if not given, those of the velocities
};

/// Base class of brains. An exception thrown by its functions ends the brain with that message.
class Brain {
 public:
  virtual ~Brain() = default;
  /// Called once, before the first step.
  virtual void Init(Aux& /*aux*/) {}
  virtual void Step(const Sensor& sensor, Motor& motor, Aux& aux) = 0;
};

/// Connects to the simulator that started this process, and runs the brain until the simulator says
/// goodbye.
/// @returns what main() returns: 0, or 1 after printing the error to stderr.
int Run(Brain& brain);

}  // namespace smile::brain_client
