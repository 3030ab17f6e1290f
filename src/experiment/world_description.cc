#include "experiment/world_description.h"

#include "math/angles.h"
#include "scene/units.h"

namespace smile::experiment {
namespace {

Json ArrayOf(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

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
