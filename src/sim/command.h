#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "demonstrator/hand.h"
#include "motion/joint_trajectory.h"
#include "robot/face_expression.h"
#include "scene/scene_spec.h"
#include "sim/by_arm.h"
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
inline constexpr CommandField kHandField{"hand", ValueKind::kHand, "hand of the demonstrator"};

/// Takes an object.
struct Grasp {
  static constexpr CommandName kName{"grasp", "grasps an object"};
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< point where it is grasped; the object's origin if not given [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.object, CommandField{"object", ValueKind::kText, "id of a whole object"});
    visit(command.p_WQ,
          CommandField{"point", ValueKind::kPoint, "point to grasp it at (default: its origin)",
                       ValueUnit::kUnits, Presence::kOptional});
  }
  bool operator==(const Grasp&) const = default;
};

/// Meaning of the `speed` of a hand.
inline constexpr const char* kSpeedMeaning = "maximum speed (default: 10)";

/// Carries the held object.
struct MoveTo {
  static constexpr CommandName kName{"move_to", "moves the held object"};
  HandName hand = HandName::kAny;
  Vector3 p_WH = Vector3::Zero();  ///< goal of the grasped point [m]
  std::optional<double> speed;     ///< greatest speed [m/s]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.p_WH, CommandField{"position", ValueKind::kPoint, "target of the grasped point",
                                     ValueUnit::kUnits});
    visit(command.speed, CommandField{"speed", ValueKind::kSpeed, kSpeedMeaning,
                                      ValueUnit::kUnitsPerSecond, Presence::kOptional});
  }
  bool operator==(const MoveTo&) const = default;
};

/// Rotates the vertical plane in which the hand is dragged.
struct Plane {
  static constexpr CommandName kName{"plane", "turns the vertical plane of motion of the hand"};
  HandName hand = HandName::kAny;
  double angle_deg = 0;  ///< from the x axis, counterclockwise seen from above

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.angle_deg,
          CommandField{
              "angle", ValueKind::kNumber,
              "angle from the x axis to its horizontal direction, counterclockwise seen from above",
              ValueUnit::kDegrees});
  }
  bool operator==(const Plane&) const = default;
};

/// Rotates the held object.
struct Rotate {
  static constexpr CommandName kName{"rotate", "rotates the held object about its origin"};
  HandName hand = HandName::kAny;
  Vector3 angles_deg = Vector3::Zero();  ///< about the world's x, then y, then z axis

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.angles_deg,
          CommandField{"angles", ValueKind::kPoint,
                       "angles about the world's x, then y, then z axis", ValueUnit::kDegrees});
  }
  bool operator==(const Rotate&) const = default;
};

/// Releases the held object.
struct Release {
  static constexpr CommandName kName{"release", "releases the held object"};
  HandName hand = HandName::kAny;

  static void VisitFields(auto& command, auto&& visit) { visit(command.hand, kHandField); }
  bool operator==(const Release&) const = default;
};

/// Removes the held object from the world.
struct Destroy {
  static constexpr CommandName kName{"destroy", "removes the held object from the world"};
  HandName hand = HandName::kAny;

  static void VisitFields(auto& command, auto&& visit) { visit(command.hand, kHandField); }
  bool operator==(const Destroy&) const = default;
};

/// Sets the properties of the held object that matter; empty: none in particular.
struct Attend {
  static constexpr CommandName kName{
      "attend", "sets the relevant properties of the held object; replaces earlier ones"};
  HandName hand = HandName::kAny;
  std::vector<std::string> properties;  ///< see Demonstrator::Attend()

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.properties, CommandField{"properties", ValueKind::kProperties,
                                           "color, shape, size, position, orientation, order, "
                                           "support, names of its descriptions; [] = none in "
                                           "particular"});
  }
  bool operator==(const Attend&) const = default;
};

/// Points at an object or a pointable part; changes only the log.
struct Point {
  static constexpr CommandName kName{
      "point", "points at an object or a pointable part; recorded, without effect on the world"};
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
      "trigger", "presses a switch or triggers a custom control; needs an empty hand"};
  HandName hand = HandName::kAny;
  std::string control;
  /// button, or part of a custom control; empty: any that leads to another state
  std::string part;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.control, CommandField{"control", ValueKind::kText, "id of the control"});
    visit(command.part,
          CommandField{
              "part", ValueKind::kText,
              "its button (ID-b1 or ID-b2) or part (default: the one that leads to the next state)",
              ValueUnit::kNone, Presence::kOptional});
  }
  bool operator==(const Trigger&) const = default;
};

/// Meaning of the `point` of fasten and loosen.
inline constexpr const char* kGuestMeaning =
    "point near its guest point (default: the object's origin)";

/// Fastens the object's guest point nearest to a point by one stage.
struct Fasten {
  static constexpr CommandName kName{"fasten", "tightens an object by one stage"};
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< the object's origin if not given [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.object,
          CommandField{"object", ValueKind::kText,
                       "id of the object; must be the held object if the hand holds one"});
    visit(command.p_WQ, CommandField{"point", ValueKind::kPoint, kGuestMeaning, ValueUnit::kUnits,
                                     Presence::kOptional});
  }
  bool operator==(const Fasten&) const = default;
};

/// Loosens the object's guest point nearest to a point by one stage.
struct Loosen {
  static constexpr CommandName kName{"loosen", "loosens an object by one stage"};
  HandName hand = HandName::kAny;
  std::string object;
  std::optional<Vector3> p_WQ;  ///< the object's origin if not given [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.object,
          CommandField{"object", ValueKind::kText,
                       "id of the object; must be the held object if the hand holds one"});
    visit(command.p_WQ, CommandField{"point", ValueKind::kPoint, kGuestMeaning, ValueUnit::kUnits,
                                     Presence::kOptional});
  }
  bool operator==(const Loosen&) const = default;
};

/// Uses the tool that the hand holds.
struct Use {
  static constexpr CommandName kName{
      "use", "uses the held tool on what its tip is at: cuts it, or turns it by one stage"};
  HandName hand = HandName::kAny;
  bool loosens = false;  ///< direction of a tool that is turned

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.hand, kHandField);
    visit(command.loosens, CommandField{"loosen", ValueKind::kFlag,
                                        "turns a screwdriver so that it loosens (default: false)",
                                        ValueUnit::kNone, Presence::kOptional});
  }
  bool operator==(const Use&) const = default;
};

/// Visits values of arms as the fields `left`, `right` and `arms`.
void VisitArms(auto& arms, ValueUnit unit, auto&& visit) {
  using Values = std::remove_reference_t<decltype(arms)>;
  OneArm<Values> left{&arms, "left"}, right{&arms, "right"};
  OtherArms<Values> others{&arms};
  visit(left, CommandField{"left", ValueKind::kJoints,
                           "arm `left`, or the first one; for Baxter s0 s1 e0 e1 w0 w1 w2", unit,
                           Presence::kOptional});
  visit(right, CommandField{"right", ValueKind::kJoints, "arm `right`, or the second one", unit,
                            Presence::kOptional});
  visit(others,
        CommandField{"arms", ValueKind::kArms, "other arms, by name", unit, Presence::kOptional});
}

/// Sets velocities that the robot keeps until the next command; omitted ones stay unchanged.
struct JointVelocities {
  static constexpr CommandName kName{"joint_velocities",
                                     "sets the robot's velocities until the next such command"};
  ByArm<std::vector<double>> arms;  ///< one per joint of the arm [rad/s; m/s of a sliding joint]
  /// Rates of the openings [m/s]. A pair `left`, `right` moves those of the two that exist.
  ByArm<double> grippers;
  std::optional<double> head;  ///< [rad/s]

  static void VisitFields(auto& command, auto&& visit) {
    VisitArms(command.arms, ValueUnit::kRadiansPerSecond, visit);
    visit(command.grippers,
          CommandField{"grippers", ValueKind::kGrippers,
                       "rate of change of each opening: of the left and right gripper, or by the "
                       "name of the arm",
                       ValueUnit::kUnitsPerSecond, Presence::kOptional});
    visit(command.head, CommandField{"head", ValueKind::kNumber, "pan",
                                     ValueUnit::kRadiansPerSecond, Presence::kOptional});
  }
  bool operator==(const JointVelocities&) const = default;
};

/// Sets joint angles at once; omitted ones stay unchanged.
struct JointAngles {
  static constexpr CommandName kName{"joint_angles", "sets the robot's joint angles immediately"};
  ByArm<std::vector<double>> arms;  ///< one per joint of the arm [rad; m of a sliding joint]
  std::optional<double> head;       ///< [rad]

  static void VisitFields(auto& command, auto&& visit) {
    VisitArms(command.arms, ValueUnit::kRadians, visit);
    visit(command.head, CommandField{"head", ValueKind::kNumber, "pan", ValueUnit::kRadians,
                                     Presence::kOptional});
  }
  bool operator==(const JointAngles&) const = default;
};

/// Sets the velocity of one joint; the others keep theirs.
struct TurnJoint {
  static constexpr CommandName kName{
      "turn", "turns one joint of the robot until the next command for it; other joints continue"};
  std::string joint;    ///< name of a joint, not of a finger
  double velocity = 0;  ///< [rad/s or m/s]; 0 stops it

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.joint, CommandField{"joint", ValueKind::kText,
                                      "name of the joint, like left_e1; not of a finger"});
    visit(command.velocity,
          CommandField{"velocity", ValueKind::kNumber, "velocity; 0 stops the joint",
                       ValueUnit::kRadiansPerSecond});
  }
  bool operator==(const TurnJoint&) const = default;
};

/// Opens or closes grippers.
struct MoveGripper {
  static constexpr CommandName kName{
      "gripper", "opens or closes a gripper of the robot until the next command for it"};
  std::string arm = "both";  ///< name of an arm, as in ByArm; `both` (left and right) or `all`
  double velocity = 0;       ///< rate of change of the opening, > 0 opens [m/s]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.arm, CommandField{"arm", ValueKind::kArm,
                                    "arm of the gripper, like left; both: left and right; all: "
                                    "all grippers"});
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
      "pose", "moves the robot's arms and head directly to a named pose; the grippers do not move"};
  static constexpr double kSpeed = 0.5;
  std::string name;
  double speed = kSpeed;  ///< fraction of the joints' limits of velocity, 0 < speed <= 1

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.name,
          CommandField{"name", ValueKind::kText, "name of a pose in the robot's side file"});
    visit(command.speed, CommandField{"speed", ValueKind::kShare,
                                      "fraction of the joints' maximum speed (default: 0.5)",
                                      ValueUnit::kNone, Presence::kDefaulted});
  }
  bool operator==(const TakePose&) const = default;
};

/// Makes joints follow a trajectory, see TrajectoryFollower. A gripper's column is its opening.
struct FollowTrajectory {
  static constexpr CommandName kName{
      "trajectory", "moves joints of the robot along a trajectory; scripts may use `file` instead"};
  motion::JointTrajectory trajectory;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.trajectory.joint_names,
          CommandField{"joints", ValueKind::kJointNames,
                       "names of the joints; left_gripper and right_gripper are openings"});
    visit(command.trajectory.points,
          CommandField{"points", ValueKind::kTrajectoryPoints,
                       "time from the start [s], positions [rad; openings in m], velocities (in "
                       "all points or in none)"});
  }
  bool operator==(const FollowTrajectory&) const = default;
};

/// Shows or hides the robot for people and cameras; physics does not change.
struct ShowRobot {
  static constexpr CommandName kName{"robot",
                                     "shows or hides the robot; does not change the physics"};
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
      "markers", "marks points for people and replaces earlier marks; the robot does not see them"};
  std::vector<Vector3> points_in_world;  ///< at most kMaxMarkers [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.points_in_world,
          CommandField{"points", ValueKind::kPoints, "positions; [] = none", ValueUnit::kUnits});
  }
  bool operator==(const Markers&) const = default;
};

/// Changes the robot's face for people to see; physics does not change.
struct Face {
  static constexpr CommandName kName{"face",
                                     "changes the face of the robot; does not change the physics"};
  robot::FaceExpression face_expression = robot::FaceExpression::kIdle;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.face_expression, CommandField{"mood", ValueKind::kFaceExpression,
                                                "idle, watching, working, puzzled or done"});
  }
  bool operator==(const Face&) const = default;
};

/// Adds the objects of a scene at their places; see sim/spawning.h. Nothing else changes.
struct Spawn {
  static constexpr CommandName kName{"spawn", "adds the objects of a scene; nothing else changes"};
  std::string xml;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.xml, CommandField{"xml", ValueKind::kSceneText,
                                    "a scene file (docs/scene-format.md) in the unit of the scene, "
                                    "without references to files and with new ids only"});
  }
  bool operator==(const Spawn&) const = default;
};

/// Removes an object from the world that nothing holds.
struct Remove {
  static constexpr CommandName kName{
      "remove", "removes an object from the world, without a hand; no hand may hold it"};
  std::string object;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.object, CommandField{"object", ValueKind::kText, "id of a whole object"});
  }
  bool operator==(const Remove&) const = default;
};

/// Field for the objects of a command for several of them.
inline constexpr CommandField kObjectsField{"objects", ValueKind::kObjects, "ids of whole objects"};

/// Moves objects together at once, without a hand, with what is connected to them; see
/// sim/displacing.h.
struct Displace {
  static constexpr CommandName kName{
      "displace", "moves objects together at once, without a hand; no hand may hold them"};
  std::vector<std::string> objects;
  Vector3 by = Vector3::Zero();  ///< the way of all of them [m]

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.objects, kObjectsField);
    visit(command.by, CommandField{"by", ValueKind::kPoint, "the way of all of them along the axes",
                                   ValueUnit::kUnits});
  }
  bool operator==(const Displace&) const = default;
};

/// Removes all objects from the world except those that a hand or gripper holds, and those
/// connected with them.
struct Clear {
  static constexpr CommandName kName{
      "clear",
      "removes all objects from the world except held objects and objects connected to them"};

  static void VisitFields(auto&, auto&&) {}
  bool operator==(const Clear&) const = default;
};

/// Replaces the present scene by another one at its start, with the same robot in its start
/// configuration; the tick is 0 again. An undo leads back into the previous scene.
///
/// A recording contains one scene: during a recording this is refused, and a later recording begins
/// with the loaded scene and the commands since.
struct Load {
  static constexpr CommandName kName{"load",
                                     "loads another scene; undo returns to the present one"};
  std::shared_ptr<const scene::SceneSpec> scene;  ///< never null in a command that is applied

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.scene, CommandField{"xml", ValueKind::kSceneText,
                                      "a scene file (docs/scene-format.md) without references to "
                                      "files; scripts may use `file` instead"});
  }
  bool operator==(const Load& other) const {
    return scene == other.scene ||
           (scene != nullptr && other.scene != nullptr && *scene == *other.scene);
  }
};

/// Takes back the last action and everything since; see IsAction().
struct Undo {
  static constexpr CommandName kName{"undo", "reverts the last action and everything after it"};

  static void VisitFields(auto&, auto&&) {}
  bool operator==(const Undo&) const = default;
};

/// Repeats the last undone action, up to the moment at which it was undone.
struct Redo {
  static constexpr CommandName kName{"redo", "repeats what the last undo reverted"};

  static void VisitFields(auto&, auto&&) {}
  bool operator==(const Redo&) const = default;
};

/// Starts a recording in a new directory.
struct StartRecording {
  static constexpr CommandName kName{"start", "starts a recording in a new directory"};
  std::string name;  ///< of the directory; a number is added if it exists
  std::string title, notes;

  static void VisitFields(auto& command, auto&& visit) {
    visit(command.name, CommandField{"name", ValueKind::kText,
                                     "name of the directory (default: the name of the scene)",
                                     ValueUnit::kNone, Presence::kOptional});
    visit(command.title, CommandField{"title", ValueKind::kText, "title of the recording",
                                      ValueUnit::kNone, Presence::kOptional});
    visit(command.notes, CommandField{"notes", ValueKind::kText, "notes about the recording",
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
using Command =
    std::variant<Grasp, MoveTo, Plane, Rotate, Release, Destroy, Attend, Point, Trigger, Fasten,
                 Loosen, Use, JointVelocities, JointAngles, TurnJoint, MoveGripper, TakePose,
                 FollowTrajectory, ShowRobot, Face, Markers, Spawn, Remove, Displace, Clear, Load,
                 Undo, Redo, StartRecording, FinishRecording>;

}  // namespace smile::sim
