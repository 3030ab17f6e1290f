#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "image/image.h"
#include "robot/urdf_reader.h"
#include "sim/eye.h"

/// What a robot program is told and what it answers, exactly as its scripts see it: lengths are in
/// file units (1 unit = 0.1 m) in the world frame of the scene file, angles in radians, row 1 of a
/// matrix is the left arm. This is the border; whoever fills these values converts.
namespace smile::brain {

inline constexpr int kLimbCount = 2;
inline constexpr int kJointCount = 7;

using LimbJoints = Eigen::Matrix<double, kLimbCount, kJointCount>;
using LimbPoints = Eigen::Matrix<double, kLimbCount, 3>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// A camera, as `aux` and `sensor` describe it.
struct CameraDescription {
  int width_px = 0;
  int height_px = 0;
  double fx = 0, fy = 0;  ///< focal lengths [px]
  double cx = 0, cy = 0;  ///< where the axis meets the image [px]
  /// Pose of the camera (x right, y down, z forward) in the world, translation in units.
  Eigen::Matrix4d X_WC = Eigen::Matrix4d::Identity();
};

/// A picture that a camera has just taken; channels nobody asked for are empty.
struct CameraPicture {
  CameraDescription camera;
  Image image;       ///< its depth is in units
  std::string name;  ///< of the camera; empty for the robot's eye
};

/// A frame of a demonstration, as it is shown to a program that asked to watch.
struct DemonstrationFrame {
  std::uint64_t tick = 0;  ///< since the first frame
  CameraView view;         ///< of the demonstration's eye [m]
  Image image;             ///< color
};

/// Returns the next frame of a demonstration; nullopt after the last one. Throws a std::exception
/// saying why it cannot be read or drawn.
using DemonstrationFrames = std::function<std::optional<DemonstrationFrame>()>;

/// Of objects of a demonstration, by id: which of their properties matter, as the demonstrator
/// told.
using Attention = std::map<std::string, std::vector<std::string>>;

/// What a program is told once, before it starts. (BrainProcess adds `aux.path`, and `aux.robot`:
/// where it has put the robot's files.)
struct Aux {
  LimbJoints min_joint_angles = LimbJoints::Zero();      ///< [rad]
  LimbJoints max_joint_angles = LimbJoints::Zero();      ///< [rad]
  LimbJoints max_joint_velocities = LimbJoints::Zero();  ///< [rad/s]
  std::optional<CameraDescription> camera;               ///< absent when there are no images
  std::vector<std::string> camera_names;                 ///< of all cameras a program may ask for
  std::vector<robot::RobotFile> robot_files;             ///< the URDF first
  std::string robot_gripper;                             ///< as robot::RobotReading tells it
  /// Pose of the robot's base (x forward, z up) in the world, translation in units.
  Eigen::Matrix4d X_WBase = Eigen::Matrix4d::Identity();
  double meters_per_unit = 0.1;
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
  bool demo_cue = false;                             ///< the picture is of the demonstration
  LimbJoints joint_velocities = LimbJoints::Zero();  ///< [rad/s]
  double head_angle = 0;                             ///< [rad]
  /// What each gripper holds, by id; empty when it holds nothing.
  std::array<std::string, kLimbCount> held_objects;
  /// Fresh ones, in the order in which they were asked for; the eye's first.
  std::vector<CameraPicture> pictures;
  /// Of the numbers in their ids, from 1 on; empty unless somebody asked for segmentation.
  std::vector<std::string> segment_names;
};

/// What a program wants its robot to do until the next step.
struct Motor {
  LimbJoints joint_velocities = LimbJoints::Zero();              ///< [rad/s]
  Eigen::Vector2d gripper_velocities = Eigen::Vector2d::Zero();  ///< left, right [units/s]
  std::optional<LimbJoints> joint_angles;  ///< to be at once, instead of velocities [rad]
  std::optional<double> head_velocity;     ///< [rad/s]
};

/// Which pictures a program wants.
struct PictureWishes {
  sim::Channels channels;
  std::vector<std::string> cameras;     ///< beside the eye, of those in Aux::camera_names
  std::optional<double> image_seconds;  ///< between fresh pictures; 0: at every step

  bool operator==(const PictureWishes&) const = default;
};

/// What the init script answered.
struct InitReply {
  std::optional<LimbJoints> init_joint_angles;  ///< where to start [rad]
  Points draw_markers = Points(0, 3);           ///< points to show to people [units]
  PictureWishes pictures;
  bool watch = false;  ///< to be shown the demonstration first
};

/// What the callback answered.
struct StepReply {
  Motor motor;
  std::optional<Points> draw_markers;  ///< other points to show to people from now on [units]
  bool exit = false;                   ///< the program set aux.exit: this was its last step
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

/// What a program is asked: first to start, then for one step after the other.
using BrainQuestion = std::variant<Aux, Sensor>;
/// To each the reply of its kind, or why there is none.
using BrainAnswer = std::variant<InitReply, StepReply, BrainError>;

/// An answer, or why there is none.
template <class Reply>
using OrError = std::variant<Reply, BrainError>;

}  // namespace smile::brain
