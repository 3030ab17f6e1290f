#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "image/image.h"
#include "robot/urdf_reader.h"
#include "sim/eye.h"
#include "sim/note.h"

/// Values sent to a brain and its answers, exactly as its scripts see them: lengths are in
/// file units (1 unit = 0.1 m) in the world frame of the scene file, angles in radians. This is the
/// boundary; code that fills these values converts.
///
/// Arms are in the order of the robot's model. Messages also contain the classic variables, 2x7
/// matrices whose row 1 is the left arm, if the robot has exactly that shape: see IsClassic().
namespace smile::brain {

/// Shape of the classic variables.
inline constexpr int kLimbCount = 2;
inline constexpr int kJointCount = 7;
/// Maximum length of a chunk: the ticks that one answer may cover.
inline constexpr int kMaxChunkTicks = 600;

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

/// Subtask of a demonstration, see analysis::Subtask.
struct PlanSubtask {
  std::string words;
  std::vector<std::string> objects;  ///< ids of objects, parts, controls and tools
  int first = 0, last = 0;           ///< its segments of the recording
  bool is_necessary = false;

  bool operator==(const PlanSubtask&) const = default;
};

/// What matters in a demonstration, see analysis::Analysis. Subtasks are referred to by their
/// indices.
struct TaskPlan {
  std::vector<PlanSubtask> subtasks;                       ///< as demonstrated; at least one
  std::vector<std::pair<std::size_t, std::size_t>> order;  ///< the first before the second
  std::vector<std::size_t> sufficient;                     ///< ascending
  std::vector<std::string> goals;  ///< ids of the objects whose places count

  bool operator==(const TaskPlan&) const = default;
};

/// Arm, as described in `aux.arms`.
struct ArmDescription {
  std::string name;
  std::vector<std::string> joint_names;
  std::vector<double> min_joints, max_joints;  ///< limits [rad; m of a sliding joint]
  std::vector<double> max_velocities;          ///< [rad/s; m/s]
  /// Openings of the closed and the open gripper [units]; nullopt without a gripper.
  std::optional<Eigen::Vector2d> gripper;
  /// Tool G in the frame of the last link L, translation in units.
  Eigen::Matrix4d X_LG = Eigen::Matrix4d::Identity();

  int num_joints() const { return static_cast<int>(joint_names.size()); }
};

/// Returns true for two arms of seven joints.
bool IsClassic(std::span<const ArmDescription> arms);

/// Variation of its behavior that a brain is asked for, where several ways are equally good; unset:
/// it is not asked. Brains may ignore it.
struct BehaviorVariation {
  std::optional<double> speed;         ///< factor of the speed of its motions, above 0
  std::optional<std::uint64_t> order;  ///< seed of the choice among steps that may be next
  std::optional<std::uint64_t> grasp;  ///< seed of the choice among grasps
  std::optional<std::uint64_t> path;   ///< seed of the choice among paths

  bool operator==(const BehaviorVariation&) const = default;
};

/// Object, as described in `aux` to a brain that is given the poses of all objects.
struct ObjectDescription {
  std::string id;
  Eigen::RowVector3d size;   ///< of the box around it, along its own axes [units]
  Eigen::RowVector3d color;  ///< of its first piece: red, green, blue
};

/// Values sent once, before the program starts. (BrainProcess adds `aux.path`, and `aux.robot`: the
/// path of the robot's files.)
struct Aux {
  std::vector<ArmDescription> arms;
  bool sends_arms = true;                     ///< false: only as classic variables; see MayRead()
  std::optional<CameraDescription> camera;    ///< nullopt without images
  std::vector<std::string> camera_names;      ///< of all cameras that a program may request
  std::vector<robot::RobotFile> robot_files;  ///< the URDF first
  std::string robot_gripper;                  ///< see robot::RobotReading
  /// Pose of the robot's base (x forward, z up) in the world, translation in units.
  Eigen::Matrix4d X_WBase = Eigen::Matrix4d::Identity();
  double meters_per_unit = 0.1;
  Eigen::RowVector2d table_size{
      20, 12};                ///< of the table top along x and y [units]; its center is the origin
  std::string demonstration;  ///< folder of the recording to imitate; empty: none
  Attention attention;        ///< of that demonstration
  std::optional<TaskPlan> plan;  ///< of that demonstration, if the brain is given one
  BehaviorVariation variation;
  std::vector<ObjectDescription> objects;  ///< empty unless the brain is given their poses
};

/// State of an arm.
struct ArmSensor {
  std::vector<double> joints;      ///< [rad; m of a sliding joint]
  std::vector<double> velocities;  ///< [rad/s; m/s]
  std::optional<double> gripper;   ///< opening [units]; nullopt without a gripper
  /// Pose of the tool G in the world, translation in units.
  Eigen::Matrix4d X_WG = Eigen::Matrix4d::Identity();
  std::string held_object;  ///< its id; empty: none
};

/// Values sent at every step.
struct Sensor {
  double time_elapsed = 0;      ///< since the previous step [s]
  double sim_time = 0;          ///< since the start of the simulation [s]
  std::vector<ArmSensor> arms;  ///< as in Aux
  bool sends_arms = true;       ///< as in Aux
  std::map<std::string, Eigen::RowVector3d, std::less<>> tracker_locations;  ///< [units]
  bool demo_cue = false;  ///< the picture is of the demonstration
  double head_angle = 0;  ///< [rad]
  /// New pictures, in the order in which they were requested; that of the eye first.
  std::vector<CameraPicture> pictures;
  /// Names for the ids in pictures, from 1 on; empty unless segmentation was requested.
  std::vector<std::string> segment_names;
  /// Poses in the world of Aux::objects, translations in units; not a number if it is absent.
  std::vector<Eigen::Matrix4d> object_poses;
};

/// Motor command of an arm.
struct ArmMotor {
  std::vector<double> velocities;             ///< of its joints [rad/s; m/s]
  double gripper_velocity = 0;                ///< rate of change of the opening [units/s]
  std::optional<std::vector<double>> joints;  ///< immediate posture in place of velocities [rad; m]
};

/// Motor command, in effect until the next one.
struct Motor {
  std::vector<ArmMotor> arms;           ///< as in Aux; empty: all arms stand still
  std::optional<double> head_velocity;  ///< [rad/s]
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
  /// Initial posture of the arms that have one [rad; m]; as in Aux, or empty.
  std::vector<std::optional<std::vector<double>>> init_joints;
  Points draw_markers = Points(0, 3);  ///< points to show to people [units]
  PictureWishes pictures;
  bool watch = false;            ///< request to watch the demonstration first
  std::vector<sim::Note> notes;  ///< about what it knows so far
};

/// Claim of a brain about its own run. Results compare it with what is true.
struct Claim {
  bool is_done = false;  ///< it did its task; otherwise it gave up
  std::string reason;    ///< in its own words; may be empty

  bool operator==(const Claim&) const = default;
};

/// Answer of the callback.
struct StepReply {
  /// Action chunk: commands of successive ticks, at least one. The last one remains in effect.
  std::vector<Motor> motors = {Motor()};
  int ticks = 1;  ///< until the next step, from 1 to kMaxChunkTicks; `motors` has no more
  std::optional<Points> draw_markers;   ///< other points to show to people from now on [units]
  std::optional<double> image_seconds;  ///< another time between pictures from now on
  /// Of PictureWishes::cameras, those whose pictures come from now on.
  std::optional<std::vector<std::string>> cameras;
  bool exit = false;             ///< the program set aux.exit: this was its last step
  std::optional<Claim> claim;    ///< with the last step only
  std::vector<sim::Note> notes;  ///< since the step before
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
