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

/// Values sent to a brain and its answers, exactly as its scripts see them: lengths are in
/// file units (1 unit = 0.1 m) in the world frame of the scene file, angles in radians, row 1 of a
/// matrix is the left arm. This is the boundary; code that fills these values converts.
namespace smile::brain {

inline constexpr int kLimbCount = 2;
inline constexpr int kJointCount = 7;
/// Maximum length of a chunk: the ticks that one answer may cover.
inline constexpr int kMaxChunkTicks = 600;

using LimbJoints = Eigen::Matrix<double, kLimbCount, kJointCount>;
using LimbPoints = Eigen::Matrix<double, kLimbCount, 3>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Camera, as described in `aux` and `sensor`.
struct CameraDescription {
  int width_px = 0;
  int height_px = 0;
  double fx = 0, fy = 0;  ///< focal lengths [px]
  double cx = 0, cy = 0;  ///< principal point [px]
  /// Pose of the camera (x right, y down, z forward) in the world, translation in units.
  Eigen::Matrix4d X_WC = Eigen::Matrix4d::Identity();
};

/// Picture of a camera; channels that were not requested are empty.
struct CameraPicture {
  CameraDescription camera;
  Image image;       ///< its depth is in units
  std::string name;  ///< of the camera; empty for the robot's eye
};

/// Frame of a demonstration for a program that watches.
struct DemonstrationFrame {
  std::uint64_t tick = 0;  ///< since the first frame
  CameraView view;         ///< of the demonstration's eye [m]
  Image image;             ///< color
};

/// Returns the next frame of a demonstration; nullopt after the last one. Throws a std::exception
/// with the reason if it cannot be read or drawn.
using DemonstrationFrames = std::function<std::optional<DemonstrationFrame>()>;

/// Properties of a demonstration's objects that matter, by object id, as specified by the
/// demonstrator.
using Attention = std::map<std::string, std::vector<std::string>>;

/// Values sent once, before the program starts. (BrainProcess adds `aux.path`, and `aux.robot`: the
/// path of the robot's files.)
struct Aux {
  LimbJoints min_joint_angles = LimbJoints::Zero();      ///< [rad]
  LimbJoints max_joint_angles = LimbJoints::Zero();      ///< [rad]
  LimbJoints max_joint_velocities = LimbJoints::Zero();  ///< [rad/s]
  std::optional<CameraDescription> camera;               ///< nullopt without images
  std::vector<std::string> camera_names;      ///< of all cameras that a program may request
  std::vector<robot::RobotFile> robot_files;  ///< the URDF first
  std::string robot_gripper;                  ///< see robot::RobotReading
  /// Pose of the robot's base (x forward, z up) in the world, translation in units.
  Eigen::Matrix4d X_WBase = Eigen::Matrix4d::Identity();
  double meters_per_unit = 0.1;
  std::string demonstration;  ///< folder of the recording to imitate; empty: none
  Attention attention;        ///< of that demonstration
};

/// Values sent at every step.
struct Sensor {
  double time_elapsed = 0;                       ///< since the previous step [s]
  double sim_time = 0;                           ///< since the start of the simulation [s]
  LimbJoints joint_angles = LimbJoints::Zero();  ///< [rad]
  LimbPoints end_effector_positions = LimbPoints::Zero();            ///< gripper origins [units]
  Eigen::RowVector2d gripper_openings = Eigen::RowVector2d::Zero();  ///< left, right [units]
  std::map<std::string, Eigen::RowVector3d, std::less<>> tracker_locations;  ///< [units]
  bool demo_cue = false;                             ///< the picture is of the demonstration
  LimbJoints joint_velocities = LimbJoints::Zero();  ///< [rad/s]
  double head_angle = 0;                             ///< [rad]
  /// Id of the object in each gripper; empty: none.
  std::array<std::string, kLimbCount> held_objects;
  /// New pictures, in the order in which they were requested; that of the eye first.
  std::vector<CameraPicture> pictures;
  /// Names for the ids in pictures, from 1 on; empty unless segmentation was requested.
  std::vector<std::string> segment_names;
};

/// Motor command, in effect until the next one.
struct Motor {
  LimbJoints joint_velocities = LimbJoints::Zero();              ///< [rad/s]
  Eigen::Vector2d gripper_velocities = Eigen::Vector2d::Zero();  ///< left, right [units/s]
  std::optional<LimbJoints> joint_angles;  ///< immediate posture in place of velocities [rad]
  std::optional<double> head_velocity;     ///< [rad/s]
};

/// Pictures that a program requests.
struct PictureWishes {
  sim::Channels channels;
  std::vector<std::string> cameras;     ///< beside the eye, of those in Aux::camera_names
  std::optional<double> image_seconds;  ///< between pictures; 0: at every step

  bool operator==(const PictureWishes&) const = default;
};

/// Answer of the init script.
struct InitReply {
  std::optional<LimbJoints> init_joint_angles;  ///< initial posture [rad]
  Points draw_markers = Points(0, 3);           ///< points to show to people [units]
  PictureWishes pictures;
  bool watch = false;  ///< request to watch the demonstration first
};

/// Answer of the callback.
struct StepReply {
  /// Action chunk: commands of successive ticks, at least one. The last one remains in effect.
  std::vector<Motor> motors = {Motor()};
  int ticks = 1;  ///< until the next step, from 1 to kMaxChunkTicks; `motors` has no more
  std::optional<Points> draw_markers;   ///< other points to show to people from now on [units]
  std::optional<double> image_seconds;  ///< another time between pictures from now on
  bool exit = false;                    ///< the program set aux.exit: this was its last step
};

/// Reason for which a program was stopped.
struct BrainError {
  enum class Phase { kStart, kInit, kCallback };

  Phase phase = Phase::kStart;
  std::string message;
  std::string file;  ///< the script, relative to the folder's parent; empty if unknown
  int line = 0;      ///< 0 if unknown
  std::vector<std::string> output;  ///< the last lines it printed
};

/// Returns a text such as `wave/waveCallback.m:12: 'x' undefined`.
std::string ToString(const BrainError& error);

/// Question to a program: first to start, then for one step after the other.
using BrainQuestion = std::variant<Aux, Sensor>;
/// Reply of the corresponding kind, or an error.
using BrainAnswer = std::variant<InitReply, StepReply, BrainError>;

/// Reply or error.
template <class Reply>
using OrError = std::variant<Reply, BrainError>;

}  // namespace smile::brain
