#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "demonstrator/hand.h"
#include "motion/joint_trajectory.h"
#include "robot/face_expression.h"
#include "scene/scene_spec.h"
#include "sim/command_field.h"

namespace smile::sim {

using demonstrator::HandName;

// Commands. Mouse, brain, script, replay and tests all send these; the simulation applies them
// between ticks, in order. SI units and the world frame.
//
// Each struct lists its fields once, in `VisitFields(command, visit)`, which calls `visit(value,
// CommandField)` for each in the order in which they are written. Everything about the written form
// follows from that: its reader, its writer and the file grid (command_json.h), the JSON Schema,
// the documents and the page's types (command_documents.h). A field `hand` is written before `do`,
// all others after it.

/// Field for the hand of a command.
inline constexpr CommandField kHandField{"hand", ValueKind::kHand,
                                         "which of the demonstrator's hands"};

/// Takes an object.
struct Grasp {
  static constexpr CommandName kName{"grasp", "takes hold of an object"};
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< point where it is grasped; the object's origin if not given [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.object, CommandField{"object", ValueKind::kText, "id of a whole object"});
    visit(command.p_WQ, CommandField{"point", ValueKind::kPoint,
                                     "where to take hold of it; its origin if not given",
                                     ValueUnit::kUnits, Presence::kOptional});
  }
  bool operator==(const Grasp&) const = default;
};

/// Meaning of the `speed` of a hand.
inline constexpr const char* kSpeedMeaning = "at most this fast; 10 if not given";

/// Carries the held object.
struct MoveTo {
  static constexpr CommandName kName{"move_to", "carries the held object"};
  HandName hand = HandName::kAny;
  Vector3 p_WH = Vector3::Zero();  ///< goal of the grasped point [m]
  std::optional<double> speed;     ///< greatest speed [m/s]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.p_WH, CommandField{"position", ValueKind::kPoint,
                                     "where the grasped point shall go", ValueUnit::kUnits});
    visit(command.speed, CommandField{"speed", ValueKind::kSpeed, kSpeedMeaning,
                                      ValueUnit::kUnitsPerSecond, Presence::kOptional});
  }
  bool operator==(const MoveTo&) const = default;
};

/// Rotates the vertical plane in which the hand is dragged.
struct Plane {
  static constexpr CommandName kName{"plane",
                                     "turns the vertical plane in which the hand is dragged"};
  HandName hand = HandName::kAny;
  double angle_deg = 0;  ///< from the x axis, counterclockwise seen from above

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.angle_deg,
          CommandField{
              "angle", ValueKind::kNumber,
              "of its horizontal direction from the x axis, counterclockwise seen from above",
              ValueUnit::kDegrees});
  }
  bool operator==(const Plane&) const = default;
};

/// Rotates the held object.
struct Rotate {
  static constexpr CommandName kName{"rotate", "turns the held object about its origin"};
  HandName hand = HandName::kAny;
  Vector3 angles_deg = Vector3::Zero();  ///< about the world's x, then y, then z axis

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.angles_deg,
          CommandField{"angles", ValueKind::kPoint, "about the world's x, then y, then z axis",
                       ValueUnit::kDegrees});
  }
  bool operator==(const Rotate&) const = default;
};

/// Releases the held object.
struct Release {
  static constexpr CommandName kName{"release", "lets go of the held object"};
  HandName hand = HandName::kAny;

  static void VisitFields(auto& command, auto&& visit) { visit(command.hand, kHandField); }
  bool operator==(const Release&) const = default;
};

/// Removes the held object from the world.
struct Destroy {
  static constexpr CommandName kName{"destroy", "takes the held object out of the world"};
  HandName hand = HandName::kAny;

  static void VisitFields(auto& command, auto&& visit) { visit(command.hand, kHandField); }
  bool operator==(const Destroy&) const = default;
};

/// Sets the properties of the held object that matter; empty: none in particular.
struct Attend {
  static constexpr CommandName kName{
      "attend",
      "tells which properties of the held object matter, instead of what was told before"};
  HandName hand = HandName::kAny;
  std::vector<std::string> properties;  ///< see Demonstrator::Attend()

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.properties, CommandField{"properties", ValueKind::kProperties,
                                           "color, shape, size, position, orientation, order, "
                                           "names of its descriptions; [] = none in particular"});
  }
  bool operator==(const Attend&) const = default;
};

/// Points at an object or a pointable part; changes only the log.
struct Point {
  static constexpr CommandName kName{"point",
                                     "points at an object or a pointable part; only the log knows"};
  HandName hand = HandName::kAny;
  std::string part;  ///< id of the object or part

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.part, CommandField{"part", ValueKind::kText, "id of the object or part"});
  }
  bool operator==(const Point&) const = default;
};

/// Presses a switch or triggers a custom control.
struct Trigger {
  static constexpr CommandName kName{
      "trigger", "presses a switch or triggers a custom control, with an empty hand"};
  HandName hand = HandName::kAny;
  std::string control;
  /// button, or part of a custom control; empty: any that leads to another state
  std::string part;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.control, CommandField{"control", ValueKind::kText, "id of the control"});
    visit(command.part,
          CommandField{"part", ValueKind::kText,
                       "its button (ID-b1 or ID-b2) or part; whatever leads on if not given",
                       ValueUnit::kNone, Presence::kOptional});
  }
  bool operator==(const Trigger&) const = default;
};

/// Meaning of the `point` of fasten and loosen.
inline constexpr const char* kGuestMeaning =
    "near its guest point that is meant; the object's origin if not given";

/// Fastens the object's guest point nearest to a point by one stage.
struct Fasten {
  static constexpr CommandName kName{"fasten", "fastens an object one stage tighter"};
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< the object's origin if not given [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.object, CommandField{"object", ValueKind::kText,
                                       "id of the object; the held one if the hand holds any"});
    visit(command.p_WQ, CommandField{"point", ValueKind::kPoint, kGuestMeaning, ValueUnit::kUnits,
                                     Presence::kOptional});
  }
  bool operator==(const Fasten&) const = default;
};

/// Loosens the object's guest point nearest to a point by one stage.
struct Loosen {
  static constexpr CommandName kName{"loosen", "loosens an object one stage"};
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< the object's origin if not given [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.object, CommandField{"object", ValueKind::kText,
                                       "id of the object; the held one if the hand holds any"});
    visit(command.p_WQ, CommandField{"point", ValueKind::kPoint, kGuestMeaning, ValueUnit::kUnits,
                                     Presence::kOptional});
  }
  bool operator==(const Loosen&) const = default;
};

/// Sets velocities that the robot keeps until the next command; omitted ones stay unchanged.
struct JointVelocities {
  static constexpr CommandName kName{"joint_velocities",
                                     "sets the robot's speeds until the next such command"};
  std::optional<std::vector<double>> left, right;  ///< one per arm joint [rad/s]
  std::optional<std::array<double, 2>> grippers;   ///< rates of the openings, left, right [m/s]
  std::optional<double> head;                      ///< [rad/s]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.left, CommandField{"left", ValueKind::kJoints, "left arm, s0 s1 e0 e1 w0 w1 w2",
                                     ValueUnit::kRadiansPerSecond, Presence::kOptional});
    visit(command.right, CommandField{"right", ValueKind::kJoints, "right arm",
                                      ValueUnit::kRadiansPerSecond, Presence::kOptional});
    visit(command.grippers, CommandField{"grippers", ValueKind::kGrippers,
                                         "rate of change of each opening, left and right",
                                         ValueUnit::kUnitsPerSecond, Presence::kOptional});
    visit(command.head, CommandField{"head", ValueKind::kNumber, "pan",
                                     ValueUnit::kRadiansPerSecond, Presence::kOptional});
  }
  bool operator==(const JointVelocities&) const = default;
};

/// Sets joint angles at once; omitted ones stay unchanged.
struct JointAngles {
  static constexpr CommandName kName{"joint_angles", "puts the robot's joints there at once"};
  std::optional<std::vector<double>> left, right;  ///< one per arm joint [rad]
  std::optional<double> head;                      ///< [rad]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.left, CommandField{"left", ValueKind::kJoints, "left arm, s0 s1 e0 e1 w0 w1 w2",
                                     ValueUnit::kRadians, Presence::kOptional});
    visit(command.right, CommandField{"right", ValueKind::kJoints, "right arm", ValueUnit::kRadians,
                                      Presence::kOptional});
    visit(command.head, CommandField{"head", ValueKind::kNumber, "pan", ValueUnit::kRadians,
                                     Presence::kOptional});
  }
  bool operator==(const JointAngles&) const = default;
};

/// Sets the velocity of one joint; the others keep theirs.
struct TurnJoint {
  static constexpr CommandName kName{
      "turn", "turns one joint of the robot until it is told otherwise; the others go on"};
  std::string joint;    ///< name of a joint, not of a finger
  double velocity = 0;  ///< [rad/s or m/s]; 0 stops it

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.joint,
          CommandField{"joint", ValueKind::kText, "its name, like left_e1; no finger"});
    visit(command.velocity,
          CommandField{"velocity", ValueKind::kNumber, "0 stops it", ValueUnit::kRadiansPerSecond});
  }
  bool operator==(const TurnJoint&) const = default;
};

/// Opens or closes a gripper.
struct MoveGripper {
  static constexpr CommandName kName{
      "gripper", "opens or closes a gripper of the robot until it is told otherwise"};
  enum class Which { kLeft, kRight, kBoth };
  Which which = Which::kBoth;
  double velocity = 0;  ///< rate of change of the opening, > 0 opens [m/s]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.which, CommandField{"arm", ValueKind::kArm, "left, right or both"});
    visit(command.velocity,
          CommandField{"velocity", ValueKind::kNumber,
                       "rate of change of the opening; above 0 opens", ValueUnit::kUnitsPerSecond});
  }
  bool operator==(const MoveGripper&) const = default;
};

/// Moves arms and head to a named pose of the robot, straight in joint space. Grippers stay as they
/// are, so that nothing is dropped.
struct TakePose {
  static constexpr CommandName kName{
      "pose", "moves the robot's arms and head straight to a named pose; grippers stay"};
  static constexpr double kSpeed = 0.5;
  std::string name;
  double speed = kSpeed;  ///< fraction of the joints' limits of velocity, 0 < speed <= 1

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.name,
          CommandField{"name", ValueKind::kText, "one of the poses in the robot's side file"});
    visit(command.speed, CommandField{"speed", ValueKind::kShare,
                                      "share of the joints' full speed; 0.5 if not given",
                                      ValueUnit::kNone, Presence::kDefaulted});
  }
  bool operator==(const TakePose&) const = default;
};

/// Makes joints follow a trajectory, see TrajectoryFollower. A gripper's column is its opening.
struct FollowTrajectory {
  static constexpr CommandName kName{
      "trajectory",
      "lets joints of the robot follow a trajectory; a script may name a file in place of it"};
  motion::JointTrajectory trajectory;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.trajectory.joint_names,
          CommandField{"joints", ValueKind::kJointNames,
                       "their names; left_gripper and right_gripper are openings"});
    visit(command.trajectory.points,
          CommandField{"points", ValueKind::kTrajectoryPoints,
                       "seconds since it began, positions [rad; an opening in m], velocities (in "
                       "all points or in none)"});
  }
  bool operator==(const FollowTrajectory&) const = default;
};

/// Shows or hides the robot for people and cameras; physics does not change.
struct ShowRobot {
  static constexpr CommandName kName{"robot", "shows or hides the robot; physics is not changed"};
  bool is_shown = true;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.is_shown, CommandField{"shown", ValueKind::kFlag, "true or false"});
  }
  bool operator==(const ShowRobot&) const = default;
};

/// Maximum number of markers.
inline constexpr std::size_t kMaxMarkers = 500;

/// Marks points for people, replacing earlier ones. They appear in views for people only, not in
/// any state, trace or picture of a robot's camera.
struct Markers {
  static constexpr CommandName kName{
      "markers", "marks points for people, in place of those before; the robot does not see them"};
  std::vector<Vector3> points_in_world;  ///< at most kMaxMarkers [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.points_in_world,
          CommandField{"points", ValueKind::kPoints, "where; [] = none", ValueUnit::kUnits});
  }
  bool operator==(const Markers&) const = default;
};

/// Changes the robot's face for people to see; physics does not change.
struct Face {
  static constexpr CommandName kName{
      "face", "changes the robot's face, for people to see; physics is not changed"};
  robot::FaceExpression face_expression = robot::FaceExpression::kIdle;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.face_expression, CommandField{"mood", ValueKind::kFaceExpression,
                                                "idle, watching, working, puzzled or done"});
  }
  bool operator==(const Face&) const = default;
};

/// Adds the objects of a scene at their places; see sim/spawning.h. Nothing else changes.
struct Spawn {
  static constexpr CommandName kName{"spawn",
                                     "adds the objects of a scene; all else stays as it is"};
  std::string xml;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.xml,
          CommandField{"xml", ValueKind::kSceneText,
                       "a scene file (docs/scene-format.md) in the unit of the scene, which names "
                       "no files and has none of the ids that were used before"});
  }
  bool operator==(const Spawn&) const = default;
};

/// Removes an object from the world that nothing holds.
struct Remove {
  static constexpr CommandName kName{
      "remove", "takes an object out of the world, without a hand; none may hold it"};
  std::string object;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.object, CommandField{"object", ValueKind::kText, "id of a whole object"});
  }
  bool operator==(const Remove&) const = default;
};

/// Removes all objects from the world except those that a hand or gripper holds, and those
/// connected with them.
struct Clear {
  static constexpr CommandName kName{
      "clear", "takes all objects out of the world but what is held, with what hangs on it"};

  static void VisitFields(auto&, auto&&) {}
  bool operator==(const Clear&) const = default;
};

/// Replaces the present scene by another one at its start, with the same robot in its start
/// configuration; the tick is 0 again. An undo leads back into the previous scene.
///
/// A recording contains one scene: during a recording this is refused, and a later recording begins
/// with the loaded scene and the commands since.
struct Load {
  static constexpr CommandName kName{
      "load", "goes to another scene, at its start; undo leads back into the one that was left"};
  std::shared_ptr<const scene::SceneSpec> scene;  ///< never null in a command that is applied

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.scene,
          CommandField{"xml", ValueKind::kSceneText,
                       "a scene file (docs/scene-format.md) that names no files; a script may "
                       "have the name of a `file` in its place"});
  }
  bool operator==(const Load& other) const {
    return scene == other.scene ||
           (scene != nullptr && other.scene != nullptr && *scene == *other.scene);
  }
};

/// Takes back the last action and everything since; see IsAction().
struct Undo {
  static constexpr CommandName kName{"undo", "takes back the last action, with everything since"};

  static void VisitFields(auto&, auto&&) {}
  bool operator==(const Undo&) const = default;
};

/// Repeats the last undone action, up to the moment at which it was undone.
struct Redo {
  static constexpr CommandName kName{"redo",
                                     "does what was undone last again, up to when it was undone"};

  static void VisitFields(auto&, auto&&) {}
  bool operator==(const Redo&) const = default;
};

/// Starts a recording in a new directory.
struct StartRecording {
  static constexpr CommandName kName{"start", "records from now on, into a new directory"};
  std::string name;  ///< of the directory; a number is added if it exists
  std::string title, notes;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.name,
          CommandField{"name", ValueKind::kText, "of the directory; the scene's if not given",
                       ValueUnit::kNone, Presence::kOptional});
    visit(command.title, CommandField{"title", ValueKind::kText, "of the recording",
                                      ValueUnit::kNone, Presence::kOptional});
    visit(command.notes, CommandField{"notes", ValueKind::kText, "about the recording",
                                      ValueUnit::kNone, Presence::kOptional});
  }
  bool operator==(const StartRecording&) const = default;
};

/// Finishes the recording.
struct FinishRecording {
  static constexpr CommandName kName{"finish", "finishes the recording"};

  static void VisitFields(auto&, auto&&) {}
  bool operator==(const FinishRecording&) const = default;
};

/// Any command. Tools list the kinds in this order.
using Command = std::variant<Grasp, MoveTo, Plane, Rotate, Release, Destroy, Attend, Point, Trigger,
                             Fasten, Loosen, JointVelocities, JointAngles, TurnJoint, MoveGripper,
                             TakePose, FollowTrajectory, ShowRobot, Face, Markers, Spawn, Remove,
                             Clear, Load, Undo, Redo, StartRecording, FinishRecording>;

}  // namespace smile::sim
