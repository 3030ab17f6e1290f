// Commands in their written form, and rounded to it.

#include <utility>

#include "base/overloaded.h"
#include "scene/units.h"
#include "sim/command_json.h"
#include "sim/internal_command_forms.h"

namespace smile::sim {

using scene::ToFileUnits;

namespace {

Json ToArray(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json ToJson(const motion::JointTrajectory& trajectory) {
  Json points = Json::array();
  for (const motion::TrajectoryPoint& point : trajectory.points) {
    points.push_back({{"seconds", point.seconds},
                      {"positions", point.positions},
                      {"velocities", point.velocities}});
  }
  return {{"do", "trajectory"}, {"joints", trajectory.joint_names}, {"points", std::move(points)}};
}

}  // namespace

Json ToJson(const Command& command, double unit) {
  const auto hand = [](HandName name, const char* what) -> Json {
    return {{"hand", ToString(name)}, {"do", what}};
  };
  const auto put = [](Json* json, const char* key, const auto& value) {
    if (value) (*json)[key] = *value;
  };
  const auto at_object = [&](const auto& command_at, const char* what) {
    Json json = hand(command_at.hand, what);
    json["object"] = command_at.object;
    if (command_at.p_WQ) json["point"] = ToArray(ToFileUnits(*command_at.p_WQ, unit));
    return json;
  };
  return std::visit(
      Overloaded{[&](const Grasp& grasp) { return at_object(grasp, "grasp"); },
                 [&](const Fasten& fasten) { return at_object(fasten, "fasten"); },
                 [&](const Loosen& loosen) { return at_object(loosen, "loosen"); },
                 [&](const Destroy& destroy) { return hand(destroy.hand, "destroy"); },
                 [&](const Point& point) {
                   Json json = hand(point.hand, "point");
                   json["part"] = point.part;
                   return json;
                 },
                 [&](const Trigger& trigger) {
                   Json json = hand(trigger.hand, "trigger");
                   json["control"] = trigger.control;
                   if (!trigger.part.empty()) json["part"] = trigger.part;
                   return json;
                 },
                 [&](const MoveTo& move) {
                   Json json = hand(move.hand, "move_to");
                   json["position"] = ToArray(ToFileUnits(move.p_WH, unit));
                   if (move.speed) json["speed"] = ToFileUnits(*move.speed, unit);
                   return json;
                 },
                 [&](const Plane& plane) {
                   Json json = hand(plane.hand, "plane");
                   json["angle"] = plane.angle_deg;
                   return json;
                 },
                 [&](const Drag& drag) {
                   Json json = hand(drag.hand, "drag");
                   json["origin"] = ToArray(ToFileUnits(drag.p_WOrigin, unit));
                   json["direction"] = ToArray(drag.direction_in_world);
                   if (drag.is_level) json["level"] = true;
                   if (drag.speed) json["speed"] = ToFileUnits(*drag.speed, unit);
                   return json;
                 },
                 [&](const Attend& attend) {
                   Json json = hand(attend.hand, "attend");
                   json["properties"] = attend.properties;
                   return json;
                 },
                 [&](const Rotate& rotate) {
                   Json json = hand(rotate.hand, "rotate");
                   json["angles"] = ToArray(rotate.angles_deg);
                   return json;
                 },
                 [&](const Release& release) { return hand(release.hand, "release"); },
                 [&](const JointVelocities& velocities) {
                   Json json = {{"do", "joint_velocities"}};
                   put(&json, "left", velocities.left);
                   put(&json, "right", velocities.right);
                   if (velocities.grippers) {
                     json["grippers"] = {ToFileUnits((*velocities.grippers)[0], unit),
                                         ToFileUnits((*velocities.grippers)[1], unit)};
                   }
                   put(&json, "head", velocities.head);
                   return json;
                 },
                 [&](const JointAngles& angles) {
                   Json json = {{"do", "joint_angles"}};
                   put(&json, "left", angles.left);
                   put(&json, "right", angles.right);
                   put(&json, "head", angles.head);
                   return json;
                 },
                 [](const TurnJoint& turn) {
                   return Json{{"do", "turn"}, {"joint", turn.joint}, {"velocity", turn.velocity}};
                 },
                 [&](const MoveGripper& move) {
                   return Json{{"do", "gripper"},
                               {"arm", kArmNames[static_cast<std::size_t>(move.which)]},
                               {"velocity", ToFileUnits(move.velocity, unit)}};
                 },
                 [](const TakePose& pose) {
                   return Json{{"do", "pose"}, {"name", pose.name}, {"speed", pose.speed}};
                 },
                 [](const FollowTrajectory& follow) { return ToJson(follow.trajectory); },
                 [&](const ShowRobot& show) {
                   return Json{{"do", "robot"}, {"shown", show.is_shown}};
                 },
                 [](const Face& face) {
                   return Json{{"do", "face"}, {"mood", ToString(face.mood)}};
                 },
                 [&](const Markers& markers) {
                   Json points = Json::array();
                   for (const Vector3& p : markers.points_in_world) {
                     points.push_back(ToArray(ToFileUnits(p, unit)));
                   }
                   return Json{{"do", "markers"}, {"points", points}};
                 },
                 [](const Undo&) {
                   return Json{{"do", "undo"}};
                 },
                 [](const Redo&) {
                   return Json{{"do", "redo"}};
                 },
                 [](const StartRecording& start) {
                   Json json = {{"do", "start"}};
                   if (!start.name.empty()) json["name"] = start.name;
                   if (!start.title.empty()) json["title"] = start.title;
                   if (!start.notes.empty()) json["notes"] = start.notes;
                   return json;
                 },
                 [](const FinishRecording&) {
                   return Json{{"do", "finish"}};
                 }},
      command);
}

Command OnFileGrid(Command command, double unit) {
  const auto round = [unit](auto& at_point) {
    if (at_point.p_WQ) at_point.p_WQ = scene::OnFileGrid(*at_point.p_WQ, unit);
  };
  std::visit(
      Overloaded{
          [&round](Grasp& grasp) { round(grasp); }, [&round](Fasten& fasten) { round(fasten); },
          [&round](Loosen& loosen) { round(loosen); },
          [unit](MoveTo& move) {
            move.p_WH = scene::OnFileGrid(move.p_WH, unit);
            if (move.speed) move.speed = scene::OnFileGrid(*move.speed, unit);
          },
          [unit](Drag& drag) {
            drag.p_WOrigin = scene::OnFileGrid(drag.p_WOrigin, unit);
            if (drag.speed) drag.speed = scene::OnFileGrid(*drag.speed, unit);
          },
          [unit](JointVelocities& velocities) {
            if (!velocities.grippers) return;
            for (double& rate : *velocities.grippers) {
              rate = scene::OnFileGrid(rate, unit);
            }
          },
          [unit](MoveGripper& move) { move.velocity = scene::OnFileGrid(move.velocity, unit); },
          [unit](Markers& markers) {
            for (Vector3& p : markers.points_in_world) p = scene::OnFileGrid(p, unit);
          },
          [](auto&) {}},
      command);
  return command;
}

}  // namespace smile::sim
