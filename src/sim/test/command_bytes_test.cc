// Recordings of earlier versions contain commands in exactly these bytes.

#include <gtest/gtest.h>

#include <set>

#include "scene/scene_spec.h"
#include "sim/command_json.h"

namespace smile::sim {
namespace {

using enum HandName;

/// A command and its line in a log.
struct Written {
  Command command;
  const char* text;
};

/// One or more commands of each kind, with numbers that no file represents exactly.
std::vector<Written> ExamplesOfHands() {
  const Vector3 p(0.1 + 0.2, -1.0 / 3, 2e-7);
  return {
      {Grasp{.hand = kLeft, .object = "b#3", .p_WQ = p},
       R"({"hand":"left","do":"grasp","object":"b#3","point":[3.0000000000000004,-3.333333333333333,2e-06]})"},
      {Grasp{.hand = kBoth, .object = "\"quoted\" \u00e4"},
       R"({"hand":"both","do":"grasp","object":"\"quoted\" ä"})"},
      {MoveTo{.hand = kRight, .p_WH = p},
       R"({"hand":"right","do":"move_to","position":[3.0000000000000004,-3.333333333333333,2e-06]})"},
      {MoveTo{.hand = kAny, .p_WH = {1, 0, -0.0}, .speed = 1.0 / 7},
       R"({"hand":"any","do":"move_to","position":[10.0,0.0,-0.0],"speed":1.4285714285714284})"},
      {Plane{.hand = kRight, .angle_deg = 100.0 / 3},
       R"({"hand":"right","do":"plane","angle":33.333333333333336})"},
      {Rotate{.hand = kBoth, .angles_deg = {45, -0.1, 1e-17}},
       R"({"hand":"both","do":"rotate","angles":[45.0,-0.1,1e-17]})"},
      {Release{.hand = kLeft}, R"({"hand":"left","do":"release"})"},
      {Destroy{.hand = kAny}, R"({"hand":"any","do":"destroy"})"},
      {Attend{.hand = kLeft, .properties = {"color", "maker's \"name\""}},
       R"({"hand":"left","do":"attend","properties":["color","maker's \"name\""]})"},
      {Attend{.hand = kRight}, R"({"hand":"right","do":"attend","properties":[]})"},
      {Point{.hand = kAny, .part = "knob"}, R"({"hand":"any","do":"point","part":"knob"})"},
      {Trigger{.hand = kLeft, .control = "S1"}, R"({"hand":"left","do":"trigger","control":"S1"})"},
      {Trigger{.hand = kLeft, .control = "S1", .part = "S1-b2"},
       R"({"hand":"left","do":"trigger","control":"S1","part":"S1-b2"})"},
      {Fasten{.hand = kRight, .object = "screw", .p_WQ = p},
       R"({"hand":"right","do":"fasten","object":"screw","point":[3.0000000000000004,-3.333333333333333,2e-06]})"},
      {Fasten{.hand = kRight, .object = "screw"},
       R"({"hand":"right","do":"fasten","object":"screw"})"},
      {Loosen{.hand = kBoth, .object = "screw", .p_WQ = p},
       R"({"hand":"both","do":"loosen","object":"screw","point":[3.0000000000000004,-3.333333333333333,2e-06]})"},
      {Loosen{.hand = kBoth, .object = "screw"},
       R"({"hand":"both","do":"loosen","object":"screw"})"},
  };
}
std::vector<Written> OtherExamples() {
  const Vector3 p(0.1 + 0.2, -1.0 / 3, 2e-7);
  return {
      {JointVelocities{.arms = {{"left", {0.1, -1.0 / 3}}, {"right", {2}}},
                       .grippers = {{"left", 0.1 / 3}, {"right", -0.2}},
                       .head = 0.7},
       R"({"do":"joint_velocities","left":[0.1,-0.3333333333333333],"right":[2.0],"grippers":[0.3333333333333333,-2.0],"head":0.7})"},
      {JointVelocities{}, R"({"do":"joint_velocities"})"},
      {JointVelocities{.arms = {{"right", {2}}, {"ur5e", {0.5, 1}}}, .grippers = {{"ur5e", 0.1}}},
       R"({"do":"joint_velocities","right":[2.0],"arms":{"ur5e":[0.5,1.0]},"grippers":{"ur5e":1.0}})"},
      {JointAngles{.arms = {{"a", {1}}, {"b", {2, 3}}}},
       R"({"do":"joint_angles","arms":{"a":[1.0],"b":[2.0,3.0]}})"},
      {MoveGripper{.arm = "ur5e"}, R"({"do":"gripper","arm":"ur5e","velocity":0.0})"},
      {Use{.hand = HandName::kLeft}, R"({"hand":"left","do":"use"})"},
      {Use{.hand = HandName::kBoth, .loosens = true},
       R"({"hand":"both","do":"use","loosen":true})"},
      {JointAngles{.arms = {{"left", {1.5}}, {"right", {0.1 + 0.2, 1}}}, .head = -1.0 / 3},
       R"({"do":"joint_angles","left":[1.5],"right":[0.30000000000000004,1.0],"head":-0.3333333333333333})"},
      {JointAngles{}, R"({"do":"joint_angles"})"},
      {TurnJoint{.joint = "left_e1", .velocity = 1.0 / 3},
       R"({"do":"turn","joint":"left_e1","velocity":0.3333333333333333})"},
      {MoveGripper{.arm = "left", .velocity = 0.1 / 3},
       R"({"do":"gripper","arm":"left","velocity":0.3333333333333333})"},
      {MoveGripper{.arm = "right", .velocity = 1},
       R"({"do":"gripper","arm":"right","velocity":10.0})"},
      {MoveGripper{.arm = "both", .velocity = -1.0 / 7},
       R"({"do":"gripper","arm":"both","velocity":-1.4285714285714284})"},
      {TakePose{.name = "ready"}, R"({"do":"pose","name":"ready","speed":0.5})"},
      {TakePose{.name = "ready", .speed = 1.0 / 3},
       R"({"do":"pose","name":"ready","speed":0.3333333333333333})"},
      {FollowTrajectory{{{"left_s0", "left_gripper"},
                         {{0, {1.0 / 3, 0.01}, {0, 0}}, {0.5, {1, 0.02}, {0.1, 1.0 / 7}}}}},
       R"({"do":"trajectory","joints":["left_s0","left_gripper"],"points":[{"seconds":0.0,"positions":[0.3333333333333333,0.01],"velocities":[0.0,0.0]},{"seconds":0.5,"positions":[1.0,0.02],"velocities":[0.1,0.14285714285714285]}]})"},
      {ShowRobot{.is_shown = false}, R"({"do":"robot","shown":false})"},
      {ShowRobot{}, R"({"do":"robot","shown":true})"},
      {Face{.face_expression = robot::FaceExpression::kPuzzled},
       R"({"do":"face","mood":"puzzled"})"},
      {Markers{.points_in_world = {p, {1, 2, 3}}},
       R"({"do":"markers","points":[[3.0000000000000004,-3.333333333333333,2e-06],[10.0,20.0,30.0]]})"},
      {Markers(), R"({"do":"markers","points":[]})"},
      {Spawn{.xml = "<tabletop/>\n"}, R"({"do":"spawn","xml":"<tabletop/>\n"})"},
      {Remove{.object = "b03"}, R"({"do":"remove","object":"b03"})"},
      {Displace{.objects = {"a", "b"}, .by = {0.1 / 3, 0, -0.1}},
       R"({"do":"displace","objects":["a","b"],"by":[0.3333333333333333,0.0,-1.0]})"},
      {Clear(), R"({"do":"clear"})"},
      {Load{std::make_shared<const scene::SceneSpec>(scene::SceneSpec{.name = "scene"})},
       R"x({"do":"load","xml":"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\" xspan=\"20\" yspan=\"12\"/>\n"})x"},
      {Undo(), R"({"do":"undo"})"},
      {Redo(), R"({"do":"redo"})"},
      {StartRecording{}, R"({"do":"start"})"},
      {StartRecording{.name = "um", .title = "UM", .notes = "twice,\n\"quickly\""},
       R"({"do":"start","name":"um","title":"UM","notes":"twice,\n\"quickly\""})"},
      {FinishRecording(), R"({"do":"finish"})"},
  };
}

void ExpectBytes(const Written& example, double meters_per_unit) {
  const Command on_grid = OnFileGrid(example.command, meters_per_unit);
  EXPECT_EQ(ToText(ToJson(on_grid, meters_per_unit)), example.text);
  EXPECT_EQ(ParseCommand(ParseJson(example.text), meters_per_unit), on_grid) << example.text;
}

TEST(CommandBytes, AreThoseOfEarlierVersions) {
  std::set<std::size_t> kinds;
  for (const auto& examples : {ExamplesOfHands(), OtherExamples()}) {
    for (const Written& example : examples) {
      ExpectBytes(example, scene::kMetersPerUnit);
      kinds.insert(example.command.index());
    }
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Command>) << "one of every kind";
}

TEST(CommandBytes, AreThoseOfEarlierVersionsInInchesToo) {
  const double inch = 0.0254;
  ExpectBytes(
      {MoveTo{.hand = kAny, .p_WH = {0.3, 0.1, 1.0 / 3}, .speed = 0.7},
       R"({"hand":"any","do":"move_to","position":[11.811023622047244,3.937007874015748,13.123359580052494],"speed":27.559055118110237})"},
      inch);
  ExpectBytes({JointVelocities{.grippers = {{"left", 0.1 / 3}, {"right", -0.2}}},
               R"({"do":"joint_velocities","grippers":[1.3123359580052494,-7.874015748031496]})"},
              inch);
  ExpectBytes({MoveGripper{.velocity = 0.1},
               R"({"do":"gripper","arm":"both","velocity":3.937007874015748})"},
              inch);
  ExpectBytes(
      {Markers{.points_in_world = {{0.3, 0.1, 1.0 / 3}}},
       R"({"do":"markers","points":[[11.811023622047244,3.937007874015748,13.123359580052494]]})"},
      inch);
}

}  // namespace
}  // namespace smile::sim
