#include "experiment/world_description.h"

#include "math/angles.h"
#include "scene/units.h"

namespace smile::experiment {
namespace {

Json ArrayOf(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

/// Returns the poses of the objects that have not gone: positions in units of the scene, rotations
/// as angles about the fixed axes x, y, z [degrees].
Json DescribeObjects(const sim::Simulation& simulation) {
  Json json = Json::object();
  for (const world::Object& object : simulation.tabletop().objects()) {
    if (!simulation.tabletop().IsPresent(object)) continue;
    const RigidTransform X_WB = simulation.physics().body(object.body).pose_in_world();
    json[object.id()] = {{"position", ArrayOf(scene::ToFileUnits(
                                          X_WB.translation(), simulation.scene().meters_per_unit))},
                         {"rotation", ArrayOf(FixedAxesAngles(X_WB.rotation()))}};
  }
  return json;
}

/// Returns the states of the controls, as in recordings.
Json DescribeControls(const sim::Simulation& simulation) {
  Json json = Json::object();
  const world::Tabletop& tabletop = simulation.tabletop();
  for (model::ControlIndex i : simulation.model().controls()) {
    const model::Control& control = simulation.model().control(i);
    if (!tabletop.IsPresent(i)) continue;
    json[control.id()] = RecordedState(control, tabletop.controls().states()[i]);
  }
  return json;
}

/// Returns the robot's joints [rad], and its grippers and hands in units of the scene; null without
/// a robot.
Json DescribeRobot(const sim::Simulation& simulation) {
  const world::RobotBody* robot = simulation.robot();
  if (robot == nullptr) return nullptr;
  const double unit = simulation.scene().meters_per_unit;
  Json json;
  for (int arm = 0; arm < robot->num_arms(); ++arm) {
    json[robot->model().arms[arm].name] = {
        {"joints", robot->ArmAngles(arm)},
        {"gripper", scene::ToFileUnits(robot->GripperOpening(arm), unit)},
        {"end_effector", ArrayOf(scene::ToFileUnits(robot->ToolPose(arm).translation(), unit))}};
  }
  json["head"] = robot->HeadAngle();
  return json;
}

}  // namespace smile::experiment
