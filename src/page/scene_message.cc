#include "page/scene_message.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "base/overloaded.h"
#include "demonstrator/demonstrator.h"
#include "model/eye.h"
#include "scene/bond_points.h"
#include "scene/controls_of.h"
#include "scene/parts.h"
#include "scene/units.h"

namespace smile::page {
namespace {

/// Returns `#rrggbb`.
std::string HexColor(const Color& color) {
  const auto byte = [](double share) {
    return static_cast<int>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
  };
  // A number sign, six digits and the zero at the end.
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color.red), byte(color.green),
                byte(color.blue));
  return text;
}

/// Adds the shape to the description of a visual, in units of the scene. Meshes are transferred
/// once, so only their number and scale are here.
void DescribeShape(const scene::VisualShape& shape, double unit, const PageMeshes& meshes,
                   Json* visual) {
  const auto units = [unit](double length) { return scene::ToFileUnits(length, unit); };
  std::visit(
      Overloaded{
          [&](const scene::Block& block) { (*visual)["block"] = PointInUnits(block.size, unit); },
          [&](const scene::Cylinder& cylinder) {
            (*visual)["cylinder"] = {units(cylinder.radius), units(cylinder.length),
                                     cylinder.sides};
          },
          [&](const scene::Sphere& sphere) { (*visual)["sphere"] = units(sphere.radius); },
          // Hulls are in meters; the page works in units.
          [&](const scene::Hull&) { (*visual)["scale"] = units(1); },
          [&](const scene::DrawnMesh& mesh) { (*visual)["scale"] = units(mesh.scale); }},
      shape);
  if (const auto number = meshes.NumberOf(shape)) (*visual)["mesh"] = *number;
}

/// Returns all visuals of the model. Their poses are in their frames, which move; the page draws a
/// visual with a choice only while that choice has the visual's variant.
Json DescribeVisuals(const model::Model& model, const PageMeshes& meshes) {
  const double unit = model.scene().meters_per_unit;
  Json visuals = Json::array();
  for (const scene::Visual& piece : model.visual_model().visuals) {
    Json visual = {{"frame", piece.frame},
                   {"object", piece.object_id},
                   {"pose", PoseInUnits(piece.X_FV, unit)},
                   {"color", HexColor(piece.color)},
                   {"choice", piece.choice},
                   {"look", piece.variant}};
    if (piece.glows) visual["glows"] = true;
    if (!piece.part_id.empty()) visual["part"] = piece.part_id;
    if (piece.button) visual["button"] = scene::ButtonId(piece.part_id, *piece.button);
    DescribeShape(piece.shape, unit, meshes, &visual);
    visuals.push_back(std::move(visual));
  }
  return visuals;
}

/// Appends the parts with an id, parents first; `around` is the id of the enclosing part.
void DescribePartsIn(const scene::Part& part, const std::string& around, Json* parts) {
  scene::ForEachChild(part, [&](const scene::Part& child) {
    // Parts without an id cannot be named in commands, but parts in them can.
    if (child.id.empty()) {
      DescribePartsIn(child, around, parts);
      return;
    }
    parts->push_back({{"id", child.id}, {"pointable", child.is_pointable}, {"within", around}});
    DescribePartsIn(child, child.id, parts);
  });
}

/// Returns the parts with an id, at any depth, parents first.
Json DescribeParts(const scene::Part& whole) {
  Json parts = Json::array();
  DescribePartsIn(whole, whole.id, &parts);
  return parts;
}

/// Describes the controls of an object, with the parts that a hand can trigger.
Json DescribeControls(const scene::Part& whole) {
  Json controls = Json::array();
  for (const scene::Part* control : scene::ControlsOf(whole)) {
    Json parts = Json::array();
    if (std::holds_alternative<scene::ToggleSwitch>(control->shape)) {
      parts = {scene::ButtonId(control->id, scene::Button::kLeft),
               scene::ButtonId(control->id, scene::Button::kRight)};
    } else if (std::holds_alternative<scene::CustomControl>(control->shape)) {
      std::set<std::string> ids;
      scene::ForEachPart(*control, [&](const scene::Part& part) {
        if (&part != control && !part.id.empty()) ids.insert(part.id);
      });
      parts = ids;
    }
    controls.push_back(
        {{"id", control->id}, {"kind", scene::KindOf(*control)}, {"parts", std::move(parts)}});
  }
  return controls;
}

/// Returns the properties of an object that a hand may declare as important.
Json PropertiesOf(const scene::ObjectSpec& object) {
  // Those that every object has, then those of its descriptions.
  Json properties = {"color", "shape", "size", "position", "orientation", "order", "support"};
  for (const scene::Description& description : object.descriptions) {
    const Json name = description.name;
    if (std::find(properties.begin(), properties.end(), name) != properties.end()) continue;
    if (description.name.size() <= demonstrator::kMaxPropertyLength) {
      properties.push_back(name);
    }
  }
  return properties;
}

Json DescribeTool(const scene::ToolSpec& tool, double meters_per_unit) {
  const Vector3 axis = tool.axis.normalized();
  const Vector3 p_BQ = tool.p_BT + tool.edge / 2 * axis;
  return {{"point", PointInUnits(p_BQ, meters_per_unit)},
          {"axis", {axis.x(), axis.y(), axis.z()}},
          {"edge", tool.edge / meters_per_unit},
          {"turns", tool.action == scene::ToolAction::kDrive}};
}

/// Returns all objects of the model. The shape's name is for people: the value of the first
/// description.
Json DescribeObjects(const model::Model& model) {
  Json objects = Json::array();
  for (model::ObjectIndex index : model.objects()) {
    const scene::ObjectSpec& object = model.object(index);
    objects.push_back(
        {{"id", object.id()},
         {"frame", std::size_t{model.frame_of(index)}},
         {"shape", object.descriptions.empty() ? "" : object.descriptions.front().value},
         {"parts", DescribeParts(object.whole)},
         {"controls", DescribeControls(object.whole)},
         {"bonds", !scene::GuestsOf(object.whole).empty()},
         {"fixed", object.is_static()},
         {"properties", PropertiesOf(object)}});
  }
  for (const model::ToolIndex index : model.tools()) {
    const model::Tool& tool = model.tool(index);
    objects[std::size_t{tool.object}]["tool"] =
        DescribeTool(*tool.spec, model.scene().meters_per_unit);
  }
  return objects;
}

/// Returns true if a joint has no command of its own: one of a gripper, or one that mimics another.
bool IsMovedByOthers(const robot::RobotModel& robot, int joint) {
  if (robot.links[static_cast<std::size_t>(joint)].mimic) return true;
  return std::ranges::any_of(robot.arms, [&](const robot::Arm& arm) {
    return arm.gripper && std::ranges::count(JointsOf(robot, *arm.gripper), joint) > 0;
  });
}

/// Returns the name of the arm that a joint belongs to; empty without one.
std::string ArmOf(const robot::RobotModel& robot, int joint) {
  for (const robot::Arm& arm : robot.arms) {
    if (std::ranges::find(arm.joints, joint) != arm.joints.end()) return arm.name;
  }
  return "";
}

Json DescribeRobot(const model::Model& model) {
  if (model.robot() == nullptr) return nullptr;
  const robot::RobotModel& robot = *model.robot();
  Json joints = Json::array(), grippers = Json::array(), poses = Json::array();
  for (int i = 0; i < robot.num_joints(); ++i) {
    // Those of grippers are described as grippers.
    if (IsMovedByOthers(robot, i)) continue;
    const scene::LinkSpec& link = robot.links[static_cast<std::size_t>(i)];
    joints.push_back({{"name", link.joint_name},
                      {"arm", ArmOf(robot, i)},
                      {"is_head", robot.head && std::ranges::count(robot.head->joints, i) > 0},
                      {"lower", link.lower},
                      {"upper", link.upper},
                      {"speed", link.max_velocity},
                      {"is_length", link.joint_type == scene::JointType::kPrismatic}});
  }
  for (const robot::Arm& arm : robot.arms) {
    if (!arm.gripper) continue;
    const double stroke =
        scene::ToFileUnits(OpeningRangeOf(robot, *arm.gripper).open, model.scene().meters_per_unit);
    grippers.push_back({{"arm", arm.name}, {"stroke", stroke}});
  }
  for (const robot::NamedPose& pose : robot.poses) poses.push_back(pose.name);
  return {{"name", robot.name},
          {"joints", std::move(joints)},
          {"grippers", std::move(grippers)},
          {"poses", std::move(poses)},
          {"cameras", CameraNames(model)}};
}

/// Returns `view` of a scene message; null without a camera for it.
Json DescribeFirstView(const scene::SceneSpec& scene) {
  const auto camera = std::ranges::find(scene.cameras, scene::kFirstView, &scene::CameraSpec::id);
  if (camera == scene.cameras.end()) return nullptr;
  return {{"eye", PointInUnits(camera->p_WC, scene.meters_per_unit)},
          {"target", PointInUnits(camera->p_WQ, scene.meters_per_unit)},
          {"angle", RadiansToDegrees(camera->vertical_field_of_view)}};
}

}  // namespace

Json PointInUnits(const Vector3& p, double meters_per_unit) {
  const Vector3 units = scene::ToFileUnits(p, meters_per_unit);
  return {units.x(), units.y(), units.z()};
}

Json PoseInUnits(const RigidTransform& X_AB, double meters_per_unit) {
  Json pose = PointInUnits(X_AB.translation(), meters_per_unit);
  const Quaternion q = X_AB.quaternion();
  for (const double number : {q.x(), q.y(), q.z(), q.w()}) pose.push_back(number);
  return pose;
}

Json SceneMessage(std::uint32_t number, const model::Model& model, const PageMeshes& meshes,
                  const std::vector<int>& variants) {
  const scene::SceneSpec& scene = model.scene();
  const scene::TableSpec& table = scene.table;
  return {{"t", "scene"},
          {"scene", number},
          {"name", scene.name},
          {"metersPerUnit", scene.meters_per_unit},
          {"table",
           {{"size",
             PointInUnits({table.x_span, table.y_span, table.thickness}, scene.meters_per_unit)}}},
          {"view", DescribeFirstView(scene)},
          {"numFrames", model.visual_model().num_frames},
          {"robotFrame",
           model.robot() == nullptr ? Json() : Json(std::size_t{*model.robot_frames().begin()})},
          {"visuals", DescribeVisuals(model, meshes)},
          {"looks", variants},
          {"objects", DescribeObjects(model)},
          {"robot", DescribeRobot(model)}};
}

}  // namespace smile::page
