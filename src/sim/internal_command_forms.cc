#include "sim/internal_command_forms.h"

#include <algorithm>

#include "motion/trajectory_shape.h"
#include "scene/units.h"

namespace smile::sim {
namespace {

using scene::FromFileUnits;

constexpr const char* kGripperMeaning = "rate of change of each opening, left and right [units/s]";

constexpr const char* kSpeedMeaning = "at most this fast; 10 if not given [units/s]";

constexpr const char* kGuestMeaning =
    "near its guest point that is meant; the object's origin if not given [units]";

Vector3 VectorOf(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}
HandName HandOf(const Json& json) {
  return *demonstrator::ParseHandName(json.at("hand").get<std::string>());
}
template <class T>
std::optional<T> OptionalOf(const Json& json, const char* key) {
  return json.contains(key) ? std::optional<T>(json.at(key).get<T>()) : std::nullopt;
}

std::optional<Vector3> OptionalPointOf(const Json& json, double unit) {
  if (!json.contains("point")) return std::nullopt;
  return FromFileUnits(VectorOf(json.at("point")), unit);
}

std::optional<double> OptionalSpeedOf(const Json& json, double unit) {
  if (!json.contains("speed")) return std::nullopt;
  return FromFileUnits(json.at("speed").get<double>(), unit);
}

MoveGripper::Which GripperOf(const Json& json) {
  const auto name = std::ranges::find(kArmNames, json.at("arm").get<std::string>());
  return static_cast<MoveGripper::Which>(name - kArmNames.begin());
}

motion::JointTrajectory TrajectoryOf(const Json& json) {
  motion::JointTrajectory trajectory{.joint_names = json.at("joints")};
  bool has_velocities = false;
  for (const Json& point : json.at("points")) {
    trajectory.points.push_back({.seconds = point.at("seconds").get<double>(),
                                 .positions = point.at("positions"),
                                 .velocities = point.value("velocities", std::vector<double>())});
    has_velocities = has_velocities || point.contains("velocities");
  }
  motion::CheckShape(trajectory, has_velocities);
  if (!has_velocities) motion::SetVelocitiesFromPositions(&trajectory);
  motion::CheckShape(trajectory);
  return trajectory;
}

}  // namespace

const std::vector<Form>& Forms() {
  static const Field kHandField{"hand", Kind::kHand, true, "which of the demonstrator's hands"};
  static const std::vector<Form> kForms = {
      {"grasp",
       "takes hold of an object",
       {kHandField,
        {"object", Kind::kText, true, "id of a whole object"},
        {"point", Kind::kPoint, false,
         "where to take hold of it; its origin if not given [units]"}},
       [](const Json& json, double unit) -> Command {
         return Grasp{.hand = HandOf(json),
                      .object = json.at("object"),
                      .p_WQ = OptionalPointOf(json, unit)};
       }},
      {"move_to",
       "carries the held object",
       {kHandField,
        {"position", Kind::kPoint, true, "where the grasped point shall go [units]"},
        {"speed", Kind::kSpeed, false, kSpeedMeaning}},
       [](const Json& json, double unit) -> Command {
         return MoveTo{.hand = HandOf(json),
                       .p_WH = FromFileUnits(VectorOf(json.at("position")), unit),
                       .speed = OptionalSpeedOf(json, unit)};
       }},
      {"plane",
       "turns the vertical plane in which the hand is dragged",
       {kHandField,
        {"angle", Kind::kNumber, true,
         "of its horizontal direction from the x axis, counterclockwise seen from above "
         "[degrees]"}},
       [](const Json& json, double) -> Command {
         return Plane{.hand = HandOf(json), .angle_deg = json.at("angle").get<double>()};
       }},
      {"drag",
       "carries the held object to where a ray meets the hand's plane; logs have the move_to",
       {kHandField,
        {"origin", Kind::kPoint, true, "where the ray begins [units]"},
        {"direction", Kind::kDirection, true, "of the ray, of any length but 0"},
        {"level", Kind::kFlag, false, "in a level plane instead; false if not given"},
        {"speed", Kind::kSpeed, false, kSpeedMeaning}},
       [](const Json& json, double unit) -> Command {
         return Drag{.hand = HandOf(json),
                     .p_WOrigin = FromFileUnits(VectorOf(json.at("origin")), unit),
                     .direction_in_world = VectorOf(json.at("direction")),
                     .is_level = json.value("level", false),
                     .speed = OptionalSpeedOf(json, unit)};
       }},
      {"rotate",
       "turns the held object about its origin",
       {kHandField,
        {"angles", Kind::kAngles, true, "about the world's x, then y, then z axis [degrees]"}},
       [](const Json& json, double) -> Command {
         return Rotate{.hand = HandOf(json), .angles_deg = VectorOf(json.at("angles"))};
       }},
      {"release",
       "lets go of the held object",
       {kHandField},
       [](const Json& json, double) -> Command { return Release{.hand = HandOf(json)}; }},
      {"destroy",
       "takes the held object out of the world",
       {kHandField},
       [](const Json& json, double) -> Command { return Destroy{.hand = HandOf(json)}; }},
      {"attend",
       "tells which properties of the held object matter, instead of what was told before",
       {kHandField,
        {"properties", Kind::kProperties, true,
         "color, shape, size, position, orientation, order, names of its descriptions; [] = none "
         "in particular"}},
       [](const Json& json, double) -> Command {
         return Attend{.hand = HandOf(json), .properties = json.at("properties")};
       }},
      {"point",
       "points at an object or a pointable part; only the log knows",
       {kHandField, {"part", Kind::kText, true, "id of the object or part"}},
       [](const Json& json, double) -> Command {
         return Point{.hand = HandOf(json), .part = json.at("part")};
       }},
      {"trigger",
       "presses a switch or triggers a custom control, with an empty hand",
       {kHandField,
        {"control", Kind::kText, true, "id of the control"},
        {"part", Kind::kText, false,
         "its button (ID-b1 or ID-b2) or part; whatever leads on if not given"}},
       [](const Json& json, double) -> Command {
         return Trigger{
             .hand = HandOf(json), .control = json.at("control"), .part = json.value("part", "")};
       }},
      {"fasten",
       "fastens an object one stage tighter",
       {kHandField,
        {"object", Kind::kText, true, "id of the object; the held one if the hand holds any"},
        {"point", Kind::kPoint, false, kGuestMeaning}},
       [](const Json& json, double unit) -> Command {
         return Fasten{.hand = HandOf(json),
                       .object = json.at("object"),
                       .p_WQ = OptionalPointOf(json, unit)};
       }},
      {"loosen",
       "loosens an object one stage",
       {kHandField,
        {"object", Kind::kText, true, "id of the object; the held one if the hand holds any"},
        {"point", Kind::kPoint, false, kGuestMeaning}},
       [](const Json& json, double unit) -> Command {
         return Loosen{.hand = HandOf(json),
                       .object = json.at("object"),
                       .p_WQ = OptionalPointOf(json, unit)};
       }},
      {"joint_velocities",
       "sets the robot's speeds until the next such command",
       {{"left", Kind::kJoints, false, "left arm, s0 s1 e0 e1 w0 w1 w2 [rad/s]"},
        {"right", Kind::kJoints, false, "right arm [rad/s]"},
        {"grippers", Kind::kGrippers, false, kGripperMeaning},
        {"head", Kind::kNumber, false, "pan [rad/s]"}},
       [](const Json& json, double unit) -> Command {
         JointVelocities command{.left = OptionalOf<std::vector<double>>(json, "left"),
                                 .right = OptionalOf<std::vector<double>>(json, "right"),
                                 .head = OptionalOf<double>(json, "head")};
         if (json.contains("grippers")) {
           const Json& rates = json.at("grippers");
           command.grippers = {FromFileUnits(rates[0].get<double>(), unit),
                               FromFileUnits(rates[1].get<double>(), unit)};
         }
         return command;
       }},
      {"joint_angles",
       "puts the robot's joints there at once",
       {{"left", Kind::kJoints, false, "left arm, s0 s1 e0 e1 w0 w1 w2 [rad]"},
        {"right", Kind::kJoints, false, "right arm [rad]"},
        {"head", Kind::kNumber, false, "pan [rad]"}},
       [](const Json& json, double) -> Command {
         return JointAngles{.left = OptionalOf<std::vector<double>>(json, "left"),
                            .right = OptionalOf<std::vector<double>>(json, "right"),
                            .head = OptionalOf<double>(json, "head")};
       }},
      {"turn",
       "turns one joint of the robot until it is told otherwise; the others go on",
       {{"joint", Kind::kText, true, "its name, like left_e1; no finger"},
        {"velocity", Kind::kNumber, true, "0 stops it [rad/s]"}},
       [](const Json& json, double) -> Command {
         return TurnJoint{.joint = json.at("joint"), .velocity = json.at("velocity").get<double>()};
       }},
      {"gripper",
       "opens or closes a gripper of the robot until it is told otherwise",
       {{"arm", Kind::kArm, true, "left, right or both"},
        {"velocity", Kind::kNumber, true,
         "rate of change of the opening; above 0 opens [units/s]"}},
       [](const Json& json, double unit) -> Command {
         return MoveGripper{.which = GripperOf(json),
                            .velocity = FromFileUnits(json.at("velocity").get<double>(), unit)};
       }},
      {"pose",
       "moves the robot's arms and head straight to a named pose; grippers stay",
       {{"name", Kind::kText, true, "one of the poses in the robot's side file"},
        {"speed", Kind::kShare, false, "share of the joints' full speed; 0.5 if not given"}},
       [](const Json& json, double) -> Command {
         return TakePose{.name = json.at("name"), .speed = json.value("speed", TakePose::kSpeed)};
       }},
      {"trajectory",
       "lets joints of the robot follow a trajectory; a script may name a file in place of it",
       {{"joints", Kind::kJointNames, true,
         "their names; left_gripper and right_gripper are openings"},
        {"points", Kind::kTrajectoryPoints, true,
         "seconds since it began, positions [rad; an opening in m], velocities (in all points or "
         "in none)"}},
       [](const Json& json, double) -> Command { return FollowTrajectory{TrajectoryOf(json)}; }},
      {"robot",
       "shows or hides the robot; physics is not changed",
       {{"shown", Kind::kFlag, true, "true or false"}},
       [](const Json& json, double) -> Command {
         return ShowRobot{.is_shown = json.at("shown").get<bool>()};
       }},
      {"face",
       "changes the robot's face, for people to see; physics is not changed",
       {{"mood", Kind::kMood, true, "idle, watching, working, puzzled or done"}},
       [](const Json& json, double) -> Command {
         return Face{.mood = *robot::ParseMood(json.at("mood").get<std::string>())};
       }},
      {"markers",
       "marks points for people, in place of those before; the robot does not see them",
       {{"points", Kind::kPoints, true, "where; [] = none [units]"}},
       [](const Json& json, double unit) -> Command {
         Markers markers;
         for (const Json& point : json.at("points")) {
           markers.points_in_world.push_back(FromFileUnits(VectorOf(point), unit));
         }
         return markers;
       }},
      {"undo",
       "takes back the last action of a hand, with everything since",
       {},
       [](const Json&, double) -> Command { return Undo(); }},
      {"redo",
       "does what was undone last again, up to when it was undone",
       {},
       [](const Json&, double) -> Command { return Redo(); }},
      {"start",
       "records from now on, into a new directory",
       {{"name", Kind::kText, false, "of the directory; the scene's if not given"},
        {"title", Kind::kText, false, "of the recording"},
        {"notes", Kind::kText, false, "about the recording"}},
       [](const Json& json, double) -> Command {
         return StartRecording{.name = json.value("name", ""),
                               .title = json.value("title", ""),
                               .notes = json.value("notes", "")};
       }},
      {"finish",
       "finishes the recording",
       {},
       [](const Json&, double) -> Command { return FinishRecording(); }},
  };
  return kForms;
}

}  // namespace smile::sim
