#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "math/image.h"

/// What a robot program is told and what it answers, exactly as its scripts see it: lengths are in
/// file units (1 unit = 0.1 m) in the world frame of the scene file, angles in radians, row 1 of a
/// matrix is the left arm. This is the border; whoever fills these values converts.
namespace smile::brain {

inline constexpr int kLimbCount = 2;
inline constexpr int kJointCount = 7;

using LimbJoints = Eigen::Matrix<double, kLimbCount, kJointCount>;
using LimbPoints = Eigen::Matrix<double, kLimbCount, 3>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// The head camera, as `aux` describes it.
struct CameraDescription {
  int width_px = 0;
  int height_px = 0;
  double fx = 0, fy = 0;  ///< focal lengths [px]
  double cx = 0, cy = 0;  ///< where the axis meets the image [px]
  /// Pose of the camera (x right, y down, z forward) in the world, translation in units.
  Eigen::Matrix4d X_WC = Eigen::Matrix4d::Identity();
};

/// Of objects of a demonstration, by id: which of their properties matter, as the demonstrator
/// told.
using Attention = std::map<std::string, std::vector<std::string>>;

/// What a program is told once, before it starts. (`aux.path` is added by BrainProcess.)
struct Aux {
  LimbJoints min_joint_angles = LimbJoints::Zero();  ///< [rad]
  LimbJoints max_joint_angles = LimbJoints::Zero();  ///< [rad]
  std::optional<CameraDescription> camera;           ///< absent when there are no images
  std::string demonstration;  ///< folder of the recording to imitate; empty when there is none
  Attention attention;        ///< of that demonstration
};

/// What a program is told at every step.
struct Sensor {
  double time_elapsed = 0;                       ///< since the step before [s]
  double sim_time = 0;                           ///< since the start of the simulation [s]
  LimbJoints joint_angles = LimbJoints::Zero();  ///< [rad]
  LimbPoints end_effector_positions = LimbPoints::Zero();            ///< gripper origins [units]
  Eigen::RowVector2d gripper_openings = Eigen::RowVector2d::Zero();  ///< left, right [units]
  std::map<std::string, Eigen::RowVector3d, std::less<>> tracker_locations;  ///< [units]
  bool demo_cue = false;            ///< a demonstration is being shown
  std::optional<Image> rgb_vision;  ///< the head image (color only), when a fresh one exists
};

/// What a program wants its robot to do until the next step.
struct Motor {
  LimbJoints joint_velocities = LimbJoints::Zero();              ///< [rad/s]
  Eigen::Vector2d gripper_velocities = Eigen::Vector2d::Zero();  ///< left, right [units/s]
  std::optional<LimbJoints> joint_angles;  ///< to be at once, instead of velocities [rad]
  std::optional<double> head_velocity;     ///< [rad/s]
};

/// What the init script answered.
struct InitReply {
  std::optional<LimbJoints> init_joint_angles;  ///< where to start [rad]
  Points draw_markers = Points(0, 3);           ///< points to show to people [units]
};

/// What the callback answered.
struct StepReply {
  Motor motor;
  bool exit = false;  ///< the program set aux.exit: this was its last step
};

/// Why a program was stopped.
struct BrainError {
  enum class Phase { kStart, kInit, kCallback };

  Phase phase = Phase::kStart;
  std::string message;
  std::string file;  ///< the script, relative to the folder's parent; empty when unknown
  int line = 0;      ///< 0 when unknown
  std::vector<std::string> output;  ///< the last lines it printed
};

/// `wave/waveCallback.m:12: 'x' undefined`.
std::string ToString(const BrainError& error);

/// An answer, or why there is none.
template <class Reply>
using OrError = std::variant<Reply, BrainError>;

}  // namespace smile::brain
