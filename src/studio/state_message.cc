#include "studio/state_message.h"

#include <cmath>
#include <string>
#include <vector>

#include "math/angles.h"
#include "scene/units.h"
#include "studio/rail_drag.h"

// The variable part of what pages show. All members are present in each message, so a page replaces
// its state and need not merge. Numbers are rounded, since unequal messages are sent again.

namespace smile::studio {
namespace {

/// Rounds to 1e-4, finer than a page displays, so that noise does not cause messages.
double Rounded(double number) { return std::round(number * 1e4) / 1e4; }

Json RoundedArray(const Vector3& v) { return {Rounded(v.x()), Rounded(v.y()), Rounded(v.z())}; }

/// Returns what keeps a held object from its goal; empty if it is there or still moves.
std::vector<physics::BodyId> StoppedBy(const demonstrator::Hand& hand,
                                       const sim::Simulation& simulation) {
  constexpr double kFar = 0.005, kFarDegrees = 3;  // from the goal [m, degrees]
  constexpr double kAtRest = 0.01;                 // [m/s]
  const physics::Body& body = simulation.physics().body(hand.held);
  const RigidTransform X_WB = body.pose_in_world();
  const double away = (hand.X_WB_goal.translation() - X_WB.translation()).norm();
  const double turned = RadiansToDegrees(
      RotationVectorBetween(X_WB.quaternion(), hand.X_WB_goal.quaternion()).norm());
  if (away < kFar && turned < kFarDegrees) return {};
  if (body.linear_velocity().norm() > kAtRest) return {};
  return simulation.physics().BodiesTouching(hand.held);
}

/// Describes where a held object is stopped, by what, by ids, "" for the table; and what can be
/// slid out of the way, such as a drawer that is half below its case.
void DescribeStop(const demonstrator::Hand& hand, const sim::Simulation& simulation,
                  Json* described) {
  const std::vector<physics::BodyId> stoppers = StoppedBy(hand, simulation);
  if (stoppers.empty()) return;
  const Vector3 p_WB = simulation.physics().body(hand.held).pose_in_world().translation();
  (*described)["stopped_at"] =
      RoundedArray(scene::ToFileUnits(p_WB, simulation.scene().meters_per_unit));
  for (const physics::BodyId stopper : stoppers) {
    const world::Object* object = simulation.tabletop().Find(stopper);
    (*described)["stopped_by"].push_back(object == nullptr ? "" : object->id());
    const physics::BodyId slider = FindSlidingOn(stopper, simulation.physics());
    if (slider && slider != hand.held) {
      (*described)["slide_first"] = simulation.tabletop().Find(slider)->id();
    }
  }
}

/// Returns the state of both hands. Positions are in units of the scene, angles in degrees.
Json DescribeHands(const sim::Simulation& simulation) {
  Json hands = Json::object();
  for (const sim::HandName name : demonstrator::kHandNames) {
    const demonstrator::Hand& hand = simulation.demonstrator().hand(name);
    Json described = {{"object", nullptr},
                      {"plane", Rounded(simulation.demonstrator().plane_angle_deg(name))}};
    // The goal is where the hand pulls; the object itself may lag behind or be blocked.
    if (hand.is_holding()) {
      const world::Object& object = *simulation.tabletop().Find(hand.held);
      described["object"] = object.id();
      const double unit = simulation.scene().meters_per_unit;
      described["goal"] =
          RoundedArray(scene::ToFileUnits(Vector3(hand.X_WB_goal * hand.p_BH), unit));
      described["place"] =
          RoundedArray(scene::ToFileUnits(Vector3(hand.X_WB_goal.translation()), unit));
      DescribeStop(hand, simulation, &described);
      if (IsOnRail(hand.held, simulation.physics())) described["on_rail"] = true;
      if (const auto work = simulation.tabletop().NearestWork(object)) {
        described["work"] = {{"target", work->target},
                             {"by", RoundedArray(scene::ToFileUnits(work->displacement, unit))}};
      }
      described["angles"] = RoundedArray(FixedAxesAngles(hand.X_WB_goal.rotation()));
    }
    hands[std::string(ToString(name))] = std::move(described);
  }
  return hands;
}

/// Returns the states of controls whose object has not gone, by their ids.
Json DescribeControls(const model::Model& model, const world::Tabletop& tabletop) {
  Json controls = Json::object();
  for (model::ControlIndex i : model.controls()) {
    const model::Control& control = model.control(i);
    if (!tabletop.IsPresent(i)) continue;
    controls[control.id()] = RecordedState(control, tabletop.controls().states()[i]);
  }
  return controls;
}

/// Returns the ids of the objects that were removed or destroyed.
Json DescribeGone(const world::Tabletop& tabletop) {
  Json gone = Json::array();
  for (const world::Object& object : tabletop.objects()) {
    if (!tabletop.IsPresent(object)) gone.push_back(object.id());
  }
  return gone;
}

/// Returns the ids of the objects that fell on the floor and are still there.
Json DescribeFallen(const world::Tabletop& tabletop) {
  Json fallen = Json::array();
  for (const world::Object& object : tabletop.objects()) {
    if (tabletop.IsPresent(object) && tabletop.HasFallen(object)) fallen.push_back(object.id());
  }
  return fallen;
}

Json DescribeGone(const model::Model& model, const recording::TraceTick& moment) {
  Json gone = Json::array();
  for (model::ObjectIndex object : model.objects()) {
    if (!moment.objects[object].is_present) gone.push_back(model.id(object));
  }
  return gone;
}

Json DescribeFallen(const library::Playback& playback) {
  Json fallen = Json::array();
  for (const std::string& id : playback.fallen()) {
    const auto object = playback.model().FindObject(id);
    if (object && playback.moment().objects[*object].is_present) fallen.push_back(id);
  }
  return fallen;
}

/// Returns the properties that the demonstrator marked as important, by object.
Json DescribeAttention(const sim::Simulation& simulation) {
  Json attention = Json::object();
  for (const world::Object& object : simulation.tabletop().objects()) {
    const auto& properties = simulation.demonstrator().PropertiesThatMatter(object);
    if (!properties.empty()) attention[object.id()] = properties;
  }
  return attention;
}

/// Returns what held tools would do if they were used now, by tool.
Json DescribeUses(const sim::Simulation& simulation) {
  const model::Model& model = simulation.model();
  Json uses = Json::object();
  for (const world::ToolUse& use : simulation.PossibleUses()) {
    // Both directions of a tool have the same target.
    Json& described = uses[model.id(model.tool(use.tool).object)];
    described["do"].push_back(use.verb);
    described["target"] = use.target;
  }
  return uses;
}

/// Returns the state of the robot; null without one. Its joints are in rad or m, the openings of
/// its grippers in units of the scene.
Json DescribeRobot(const sim::Simulation& simulation) {
  const world::RobotBody* robot = simulation.robot();
  if (robot == nullptr) return nullptr;
  const std::vector<double> q = robot->positions();
  Json joints = Json::object(), grippers = Json::array();
  for (std::size_t i = 0; i < q.size(); ++i) {
    joints[robot->model().links[i].joint_name] = Rounded(q[i]);
  }
  for (int arm = 0; arm < robot->num_arms(); ++arm) {
    const auto& gripper = robot->model().arms[static_cast<std::size_t>(arm)].gripper;
    if (!gripper) continue;
    grippers.push_back(Rounded(
        scene::ToFileUnits(robot->GripperOpening(arm), simulation.scene().meters_per_unit)));
    // The opening stands for the joints of the gripper.
    for (const int finger : JointsOf(robot->model(), *gripper)) {
      joints.erase(robot->model().links[static_cast<std::size_t>(finger)].joint_name);
    }
  }
  for (const scene::LinkSpec& link : robot->model().links) {
    if (link.mimic) joints.erase(link.joint_name);
  }
  return {{"shown", simulation.is_robot_shown()},
          {"mood", ToString(simulation.face_expression())},
          {"following", simulation.is_robot_following()},
          {"joints", std::move(joints)},
          {"grippers", std::move(grippers)},
          {"head", Rounded(robot->HeadAngle())}};
}

}  // namespace

/// Returns the state of the live world.
Json DescribeLive(const sim::Simulation& simulation) {
  return {{"tick", simulation.tick()},
          {"hands", DescribeHands(simulation)},
          {"uses", DescribeUses(simulation)},
          {"still", simulation.is_still()},
          {"controls", DescribeControls(simulation.model(), simulation.tabletop())},
          {"gone", DescribeGone(simulation.tabletop())},
          {"fallen", DescribeFallen(simulation.tabletop())},
          {"attention", DescribeAttention(simulation)},
          {"robot", DescribeRobot(simulation)}};
}

/// Returns the state of a played moment, with the same members as DescribeLive(). Those about
/// hands, tools, controls, important properties and the robot are empty.
Json DescribeShown(const library::Playback& playback) {
  const recording::TraceTick& moment = playback.moment();
  Json hands = Json::object();
  for (const sim::HandName name : demonstrator::kHandNames) {
    hands[std::string(ToString(name))] = {{"object", nullptr}, {"plane", 0}};
  }
  return {{"tick", moment.tick},
          {"hands", std::move(hands)},
          {"uses", Json::object()},
          {"still", true},
          {"controls", Json::object()},
          {"gone", DescribeGone(playback.model(), moment)},
          {"fallen", DescribeFallen(playback)},
          {"attention", Json::object()},
          {"robot", nullptr}};
}

}  // namespace smile::studio
