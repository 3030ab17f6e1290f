#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brain_client/fields.h"

/// A brain's side of the protocol with the simulator. docs/brains.md has an example.
namespace smile::brain_client {

/// Arm of the robot.
struct Arm {
  std::string name;
  std::vector<std::string> joints;             ///< their names, from the shoulder to the wrist
  Eigen::VectorXd min_joints, max_joints;      ///< limits [rad; m of a sliding joint]
  Eigen::VectorXd max_velocities;              ///< [rad/s; m/s]
  std::optional<Eigen::Vector2d> gripper;      ///< openings, closed and open [units]; or none
  Eigen::Matrix4d tool_pose;                   ///< in the frame of the last link [units]
  std::optional<Eigen::VectorXd> init_joints;  ///< set in Init(): initial posture [rad; m]
};

/// Subtask of a demonstration.
struct PlanSubtask {
  std::string words;
  std::vector<std::string> objects;  ///< ids of the objects, parts, controls and tools it is about
  int first_segment = 0, last_segment = 0;  ///< of the recording
  bool is_necessary = false;
};

/// What matters in a demonstration (docs/analysis.md). Subtasks are referred to by their indices.
struct Plan {
  std::vector<PlanSubtask> subtasks;                       ///< in the demonstrated order
  std::vector<std::pair<std::size_t, std::size_t>> order;  ///< the first must be before the second
  std::vector<std::size_t> sufficient;                     ///< achieve the goal by themselves
  std::vector<std::string> goals;                          ///< ids of objects whose places count
};

/// What the simulator describes once, and the settings that a brain may change.
struct Aux : Fields {
  using Fields::Fields;

  std::vector<Arm> arms;     ///< all arms, in the order of Sensor and Motor
  std::optional<Plan> plan;  ///< of the demonstration, if the run gives one

  std::optional<Eigen::MatrixXd> init_joint_angles;  ///< in Init(): limbs x joints [rad]
  std::vector<std::string> channels;                 ///< in Init(): `rgb`, `depth`, `segmentation`
  std::vector<std::string>
      cameras;  ///< besides the robot's eye; after Init(), some of those set there
  std::optional<double> image_seconds;           ///< at any time: between images [s]
  bool watch = false;                            ///< in Init(): watch the demonstration first
  std::optional<Eigen::MatrixX3d> draw_markers;  ///< at any time: points to show [units]
  bool exit = false;                             ///< ends the brain after the step that sets it
  /// With `exit`: what it claims about its run, `done` or `gave up`, optionally followed by a colon
  /// and a reason.
  std::optional<std::string> claim;

  /// At any time: notes about its work for people, sent once and then cleared; each is `word: text`
  /// (docs/brains.md).
  std::vector<std::string> notes;
  /// Tops of objects that they are about, one in each row: the number of the note, from 1; 0 for
  /// an expected one, 1 for one that was found; x, y, z of its middle [units]; its sides [units];
  /// its yaw [rad]; 1 if it is round.
  Eigen::Matrix<double, Eigen::Dynamic, 9> note_tops;
  /// Cameras of whose pictures they are, some of `cameras`, in the order of the notes; empty, or
  /// none at the end, for the eye.
  std::vector<std::string> note_cameras;
};

/// State of an arm.
struct ArmSensor {
  Eigen::VectorXd joints;         ///< [rad; m of a sliding joint]
  Eigen::VectorXd velocities;     ///< [rad/s; m/s]
  std::optional<double> gripper;  ///< opening [units]; nullopt without a gripper
  Eigen::Matrix4d end_effector;   ///< pose of the tool in the world, translation in units
  std::string held_object;        ///< id; empty: none
};

/// Inputs of a step.
struct Sensor : Fields {
  using Fields::Fields;

  std::vector<ArmSensor> arms;  ///< as in Aux
};

/// Command for an arm.
struct ArmMotor {
  Eigen::MatrixXd velocities;             ///< joints x 1, or joints x N for N ticks [rad/s; m/s]
  Eigen::VectorXd gripper_velocity;       ///< one number, or N [units/s]
  std::optional<Eigen::VectorXd> joints;  ///< sets the joints at once [rad; m]
};

/// Outputs of a step. Each keeps its value until the brain changes it.
///
/// A brain sets either `arms` or, for two arms of seven joints, the matrices below. Their
/// velocities may be those of N successive ticks, one block after the other: joint_velocities then
/// is limbs x (joints * N), gripper_velocities has limbs * N numbers.
struct Motor {
  std::vector<ArmMotor> arms;                   ///< as in Aux
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
