#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "demonstrator/hand.h"
#include "motion/joint_trajectory.h"
#include "robot/mood.h"

namespace smile::sim {

using demonstrator::HandName;

// What somebody wants. Mouse, brain, script, replay and tests all send these; the simulation
// applies them between ticks, in order. SI units and the world frame; see command_json.h for the
// written form.

struct Grasp {
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< where the hand takes hold; the object's origin if not given [m]
  bool operator==(const Grasp&) const = default;
};

struct MoveTo {
  HandName hand = HandName::kAny;
  Vector3 p_WH = Vector3::Zero();  ///< where the grasped point shall go [m]
  std::optional<double> speed;     ///< at most this fast [m/s]
  bool operator==(const MoveTo&) const = default;
};

/// Turns the vertical plane in which the hand is dragged.
struct Plane {
  HandName hand = HandName::kAny;
  double angle_deg = 0;  ///< from the x axis, counterclockwise seen from above
  bool operator==(const Plane&) const = default;
};

/// A mouse that drags: a MoveTo to where its ray meets the hand's motion plane, or a level one. It
/// is this MoveTo that is told and logged.
struct Drag {
  HandName hand = HandName::kAny;
  Vector3 p_WOrigin = Vector3::Zero();           ///< of the ray [m]
  Vector3 direction_in_world = Vector3::Zero();  ///< of any length but 0
  bool is_level = false;        ///< in the level plane through where the hand wants to be
  std::optional<double> speed;  ///< at most this fast [m/s]
  bool operator==(const Drag&) const = default;
};

struct Rotate {
  HandName hand = HandName::kAny;
  Vector3 angles_deg = Vector3::Zero();  ///< about the world's x, then y, then z axis
  bool operator==(const Rotate&) const = default;
};

struct Release {
  HandName hand = HandName::kAny;
  bool operator==(const Release&) const = default;
};

/// Takes the held object out of the world.
struct Destroy {
  HandName hand = HandName::kAny;
  bool operator==(const Destroy&) const = default;
};

/// Tells which properties of the held object matter; none: nothing in particular.
struct Attend {
  HandName hand = HandName::kAny;
  std::vector<std::string> properties;  ///< see Demonstrator::Attend()
  bool operator==(const Attend&) const = default;
};

/// Shows an object or a pointable part; only the log knows.
struct Point {
  HandName hand = HandName::kAny;
  std::string part;  ///< id of the object or part
  bool operator==(const Point&) const = default;
};

struct Trigger {
  HandName hand = HandName::kAny;
  std::string control;
  std::string part;  ///< the button, or the part of a custom control; empty: whatever leads on
  bool operator==(const Trigger&) const = default;
};

/// One stage tighter, of the object's guest point nearest to a point.
struct Fasten {
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< the object's origin if not given [m]
  bool operator==(const Fasten&) const = default;
};

struct Loosen {
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< the object's origin if not given [m]
  bool operator==(const Loosen&) const = default;
};

/// Velocities the robot keeps until the next command; what is not given stays as it was.
struct JointVelocities {
  std::optional<std::vector<double>> left, right;  ///< one per arm joint [rad/s]
  std::optional<std::array<double, 2>> grippers;   ///< rates of the openings, left, right [m/s]
  std::optional<double> head;                      ///< [rad/s]
  bool operator==(const JointVelocities&) const = default;
};

/// Angles the robot takes at once; what is not given stays as it was.
struct JointAngles {
  std::optional<std::vector<double>> left, right;  ///< one per arm joint [rad]
  std::optional<double> head;                      ///< [rad]
  bool operator==(const JointAngles&) const = default;
};

/// Turns one joint, and keeps the others as they are.
struct TurnJoint {
  std::string joint;    ///< by its name; no finger
  double velocity = 0;  ///< [rad/s or m/s]; 0 stops it
  bool operator==(const TurnJoint&) const = default;
};

/// Opens or closes a gripper.
struct MoveGripper {
  enum class Which { kLeft, kRight, kBoth };
  Which which = Which::kBoth;
  double velocity = 0;  ///< rate of change of the opening, > 0 opens [m/s]
  bool operator==(const MoveGripper&) const = default;
};

/// Moves arms and head to a named pose of the robot, all joints straight there. Grippers stay as
/// they are, so that nothing is dropped.
struct TakePose {
  static constexpr double kSpeed = 0.5;
  std::string name;
  double speed = kSpeed;  ///< share of the joints' limits of velocity, 0 < speed <= 1
  bool operator==(const TakePose&) const = default;
};

/// Lets joints follow a trajectory, see TrajectoryFollower. A gripper's column is its opening.
struct FollowTrajectory {
  motion::JointTrajectory trajectory;
  bool operator==(const FollowTrajectory&) const = default;
};

/// Shows or hides the robot: what people and cameras see, never the physics.
struct ShowRobot {
  bool is_shown = true;
  bool operator==(const ShowRobot&) const = default;
};

/// More points than these are nobody's.
inline constexpr std::size_t kMaxMarkers = 500;

/// Marks points for people, in place of those marked before. They are in views for people only:
/// no state, no trace and no picture of a robot's camera knows of them.
struct Markers {
  std::vector<Vector3> points_in_world;  ///< at most kMaxMarkers [m]
  bool operator==(const Markers&) const = default;
};

/// Changes the robot's face: what people see, never the physics.
struct Face {
  robot::Mood mood = robot::Mood::kIdle;
  bool operator==(const Face&) const = default;
};

/// Takes back the last action of a hand, with everything since; see IsAction().
struct Undo {
  bool operator==(const Undo&) const = default;
};

/// Does the last undone action again, up to the moment at which it was undone.
struct Redo {
  bool operator==(const Redo&) const = default;
};

/// From now on everything is recorded, into a new directory.
struct StartRecording {
  std::string name;  ///< of the directory; a number is added if it is taken
  std::string title, notes;
  bool operator==(const StartRecording&) const = default;
};

struct FinishRecording {
  bool operator==(const FinishRecording&) const = default;
};

using Command = std::variant<Grasp, MoveTo, Plane, Drag, Rotate, Release, Destroy, Attend, Point,
                             Trigger, Fasten, Loosen, JointVelocities, JointAngles, TurnJoint,
                             MoveGripper, TakePose, FollowTrajectory, ShowRobot, Face, Markers,
                             Undo, Redo, StartRecording, FinishRecording>;

/// True of what a hand does to the world or shows: it begins a new segment of a recording, and can
/// be undone.
template <class Kind>
inline constexpr bool kIsAction =
    std::is_same_v<Kind, Grasp> || std::is_same_v<Kind, Release> || std::is_same_v<Kind, Destroy> ||
    std::is_same_v<Kind, Point> || std::is_same_v<Kind, Trigger> || std::is_same_v<Kind, Fasten> ||
    std::is_same_v<Kind, Loosen>;
inline bool IsAction(const Command& command) {
  return std::visit([]<class Kind>(const Kind&) { return kIsAction<Kind>; }, command);
}

}  // namespace smile::sim
