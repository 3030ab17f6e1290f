// The messages about scenes.

#include <gtest/gtest.h>

#include "base/bytes.h"
#include "base/files.h"
#include "page/scene_message.h"
#include "recording/view_sample.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"
#include "studio/pose_stream.h"

namespace smile::studio {
namespace {

TEST(SceneMessage, UsesTheUnitsOfTheFile) {
  const auto scene = scene_xml::ReadSceneText(
                         R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml" xspan="24">
  <block id="a" color="red" xspan="2" location="(1, 2, 0.5)"/>
  <frustum id="p" location="(5, 2, 0.5)"/>
  <frustum id="q" location="(-5, 2, 0.5)"/>
  <toggleSwitch id="s" location="(3, 3, 0.1)"/>
  <camera id="first_view" location="(1, -6, 9)" target="(0, 1, 0)" fov="50"/>
</tabletop>)xml",
                         "some.xml")
                         .scene;
  ASSERT_TRUE(scene.has_value());
  const model::Model model(*scene);
  const page::PageMeshes meshes(model.visual_model());
  EXPECT_EQ(meshes.size(), 1u) << "equal frustums are one mesh";
  const Json message = page::SceneMessage(
      3, model, meshes, recording::VisualStateAt(recording::StartOf(model), model).variants);
  EXPECT_EQ(message["table"]["size"], Json::array({24.0, 12.0, 4.0}));
  EXPECT_EQ(message["view"]["eye"], Json::array({1.0, -6.0, 9.0}));
  EXPECT_NEAR(message["view"]["angle"].get<double>(), 50, 1e-9);
  EXPECT_EQ(message["visuals"][1]["block"], Json::array({2.0, 1.0, 1.0}));
  EXPECT_EQ(message["visuals"][1]["color"], "#ff0000");
  EXPECT_EQ(message["visuals"][2]["mesh"], 0);
  EXPECT_EQ(message["visuals"][2]["scale"], 10.0);
  EXPECT_EQ(message["objects"][0]["frame"], 1);
  EXPECT_EQ(message["objects"][3]["controls"][0]["parts"], Json::array({"s-b1", "s-b2"}));
  const Json left = message["visuals"][4], right = message["visuals"][5];
  EXPECT_EQ(left["part"], "s");
  EXPECT_EQ(left["button"], "s-b1");
  EXPECT_EQ(right["button"], "s-b2");
  EXPECT_FALSE(message["visuals"][1].contains("button"));
  EXPECT_TRUE(message["robot"].is_null() && message["robotFrame"].is_null());

  const std::string bytes = *meshes.Bytes(0);
  ByteReader reader(std::as_bytes(std::span(bytes.data(), bytes.size())));
  const auto corners = reader.Get<std::uint32_t>(), triangles = reader.Get<std::uint32_t>();
  EXPECT_EQ(bytes.size(), 8 + 24 * corners + 12 * triangles);
  EXPECT_FALSE(meshes.Bytes(1).has_value());
}

TEST(SceneMessage, MarksGlowingVisualsAsFilmsDo) {
  const auto scene = scene_xml::ReadSceneText(
                         R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="a" color="red" location="(0, 0, 0.5)"/>
  <indicatorLights id="lamp" location="(6, 3, 0.1)" numLights="2">
    <state><light id="0" color="green"/></state>
  </indicatorLights>
</tabletop>)xml",
                         "some.xml")
                         .scene;
  ASSERT_TRUE(scene.has_value());
  const model::Model model(
      *scene, model::RobotPlacement{.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))});
  const Json message =
      page::SceneMessage(1, model, page::PageMeshes(model.visual_model()),
                         recording::VisualStateAt(recording::StartOf(model), model).variants);
  EXPECT_TRUE(message["view"].is_null());
  const auto& visuals = model.visual_model().visuals;
  ASSERT_EQ(message["visuals"].size(), visuals.size());
  int num_lamps = 0, num_of_face = 0;
  for (std::size_t i = 0; i < visuals.size(); ++i) {
    const bool is_lamp = visuals[i].part_id == "lamp";
    const bool is_face = visuals[i].choice == model.visual_model().num_choices - 1;
    EXPECT_EQ(visuals[i].glows, is_lamp || is_face) << i;
    EXPECT_EQ(message["visuals"][i].value("glows", false), visuals[i].glows) << i;
    num_lamps += is_lamp ? 1 : 0;
    num_of_face += is_face ? 1 : 0;
  }
  EXPECT_EQ(num_lamps, 1);
  EXPECT_GT(num_of_face, 0);
}

TEST(SceneMessage, NamesTheJointOfTheHead) {
  robot::RobotModel robot = robot::ReadRobot(DataFile("robots/baxter.urdf"));
  robot.links[1].joint_name = "head_of_nothing";
  const std::string pan =
      robot.links[static_cast<std::size_t>(robot.head->joints.front())].joint_name;
  const model::Model model({}, model::RobotPlacement{.model = std::move(robot)});
  const Json message =
      page::SceneMessage(1, model, page::PageMeshes(model.visual_model()),
                         recording::VisualStateAt(recording::StartOf(model), model).variants);
  std::string heads;
  for (const Json& joint : message["robot"]["joints"]) {
    if (joint["is_head"] == true) heads += joint["name"].get<std::string>();
  }
  EXPECT_EQ(heads, pan);
}

TEST(PoseStream, SendsMovedFramesAndSometimesAll) {
  scene::VisualModel model{.num_frames = 3};
  library::DisplayedState view{.model = &model, .scene = 1};
  view.state.poses.resize(3);
  PoseStream stream;
  EXPECT_TRUE(stream.Next(view).is_key);
  EXPECT_TRUE(stream.Next(view).frames.empty());
  view.state.poses[2] = RigidTransform(Vector3(0.1, 0, 0.2));
  const page::Poses moved = stream.Next(view);
  EXPECT_FALSE(moved.is_key);
  EXPECT_EQ(moved.frames, std::vector<std::uint32_t>{2});
  EXPECT_EQ(moved.values, (std::vector<float>{1, 0, 2, 0, 0, 0, 1}));
  view.scene = 2;
  EXPECT_EQ(stream.Next(view).frames.size(), 2u);
  int num_all = 0;
  for (int i = 0; i < 120; ++i) num_all += stream.Next(view).is_key ? 1 : 0;
  EXPECT_EQ(num_all, 2);
}

}  // namespace
}  // namespace smile::studio
