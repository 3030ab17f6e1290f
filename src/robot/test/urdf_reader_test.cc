#include "robot/urdf_reader.h"

#include <gtest/gtest.h>

#include <numbers>

#include "robot/test/robot_files.h"

namespace smile::robot {
namespace {

class UrdfReader : public RobotFiles {};

TEST_F(UrdfReader, ReadsLinksJointsAndShapes) {
  const RobotModel model = Read(SmallRobot().Text());
  EXPECT_EQ(model.name, "small");
  ASSERT_EQ(model.num_joints(), 1);
  const scene::LinkSpec& arm = model.links[0];
  EXPECT_EQ(arm.name, "arm");
  EXPECT_EQ(arm.joint_name, "turn");
  EXPECT_EQ(arm.parent, -1);
  EXPECT_EQ(arm.axis, Vector3(0, 0, 1)) << "unit length, whatever the file says";
  EXPECT_EQ(arm.X_PJ.translation(), Vector3(0, 0, 1));
  EXPECT_EQ(arm.lower, -1);
  EXPECT_EQ(arm.upper, 2);
  EXPECT_EQ(arm.max_velocity, 3);
  EXPECT_EQ(arm.max_effort, 4);
  EXPECT_EQ(arm.mass, 2);
  ASSERT_EQ(arm.solids.size(), 1u);
  EXPECT_EQ(arm.solids[0].shape, (scene::SolidShape(scene::Block{{1, 2, 3}})));
  EXPECT_EQ(model.q_start, std::vector<double>{0.0});
}

TEST_F(UrdfReader, TurnsCylindersFromZToY) {
  const RobotModel model =
      Read(SmallRobot{.shape = R"(<origin xyz="1 0 0" rpy="0 1.5707963267948966 0"/>
        <geometry><cylinder radius="0.1" length="2"/></geometry>)"}
               .Text());
  const scene::Solid& solid = model.links[0].solids[0];
  EXPECT_EQ(solid.shape, (scene::SolidShape(scene::Cylinder{.radius = 0.1, .length = 2})));
  // Its own y, the cylinder's axis, lies where the file's z does: along the link's x.
  EXPECT_LT((solid.X_BS.rotation().col(1) - Vector3(1, 0, 0)).norm(), 1e-12);
  EXPECT_NEAR(solid.X_BS.rotation().determinant(), 1, 1e-12);
}

TEST_F(UrdfReader, MergesWhatIsFixedIntoTheLinkThatCarriesIt) {
  const RobotModel model = Read(SmallRobot{.extra = R"(
  <link name="hand">
    <inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><sphere radius="0.5"/></geometry>
      <material name="red"><color rgba="1 0 0 1"/></material></visual>
  </link>
  <joint name="weld" type="fixed"><parent link="arm"/><child link="hand"/>
    <origin xyz="1 0 0"/></joint>)"}
                                    .Text());
  ASSERT_EQ(model.num_joints(), 1);
  const scene::LinkSpec& arm = model.links[0];
  // Two equal masses 1 m apart on x: each lies 0.5 m from the middle.
  EXPECT_EQ(arm.mass, 4);
  EXPECT_LT((arm.p_LLcm - Vector3(0.5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((arm.inertia.diagonal() - Vector3(2, 3, 3)).norm(), 1e-12);

  const int hand = FindFrame(model, "hand").value();
  EXPECT_EQ(model.frames[hand].link, 0);
  EXPECT_EQ(model.frames[hand].X_LF.translation(), Vector3(1, 0, 0));
  ASSERT_EQ(model.visuals.size(), 1u);
  EXPECT_EQ(model.visuals[0].link, 0);
  EXPECT_EQ(model.visuals[0].X_LV.translation(), Vector3(1, 0, 0));
  EXPECT_EQ(model.visuals[0].color, (Color{1, 0, 0}));
}

TEST_F(UrdfReader, ListsParentsBeforeChildrenInAnyFileOrder) {
  const RobotModel model = Read(SmallRobot{.extra = R"(
  <joint name="a_slide" type="prismatic"><parent link="arm"/><child link="finger"/>
    <axis xyz="1 0 0"/><limit lower="0.25" upper="1" velocity="1" effort="1"/></joint>
  <link name="finger"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>)"}
                                    .Text());
  ASSERT_EQ(model.num_joints(), 2);
  EXPECT_EQ(model.links[1].joint_name, "a_slide");
  EXPECT_EQ(model.links[1].joint_type, scene::JointType::kPrismatic);
  EXPECT_EQ(model.links[1].parent, 0);
  EXPECT_EQ(model.q_start, (std::vector<double>{0.0, 0.25})) << "the limit next to 0";
}

TEST_F(UrdfReader, NamesTheLineOfAWrongNumber) {
  EXPECT_EQ(Complaint(SmallRobot{.shape = R"(<geometry><box size="1 -2 3"/></geometry>)"}.Text()),
            "r.urdf:4: <link name=\"arm\">: box size is -2, expected above 0 to 100");
  EXPECT_EQ(Complaint(SmallRobot{.axis = R"(<axis xyz="0 0 0"/>)"}.Text()),
            "r.urdf:7: <joint name=\"turn\">: axis has the length 0, expected a direction");
  EXPECT_EQ(
      Complaint(
          SmallRobot{.limit = R"(<limit lower="1" upper="-1" velocity="3" effort="4"/>)"}.Text()),
      "r.urdf:7: <joint name=\"turn\">: lower limit is 1, expected less than the upper, -1");
  EXPECT_EQ(
      Complaint(
          SmallRobot{.limit = R"(<limit lower="0" upper="1" velocity="0" effort="4"/>)"}.Text()),
      "r.urdf:7: <joint name=\"turn\">: velocity limit is 0, expected above 0 to 10000");
}

TEST_F(UrdfReader, RefusesNumbersThatAreNone) {
  for (const char* number : {"nan", "inf", "1e999", "1m", ""}) {
    const std::string message = Complaint(
        SmallRobot{.shape = "<geometry><sphere radius=\"" + std::string(number) + "\"/></geometry>"}
            .Text());
    EXPECT_TRUE(message.starts_with("r.urdf:4: ")) << number << ": " << message;
  }
}

TEST_F(UrdfReader, RefusesAnUndefinedColor) {
  EXPECT_EQ(Complaint(SmallRobot{.extra = R"(<link name="x"><visual><geometry>
<sphere radius="1"/></geometry><material name="mauve"/></visual></link>
<joint name="weld" type="fixed"><parent link="arm"/><child link="x"/></joint>)"}
                          .Text()),
            "r.urdf:9: <link name=\"x\">: material \"mauve\" is not defined");
}

TEST_F(UrdfReader, RefusesAMovingLinkWithoutARealMass) {
  EXPECT_EQ(Complaint(SmallRobot{.inertial = ""}.Text()),
            "r.urdf:4: <link name=\"arm\">: it moves but has no mass, expected <inertial> with a "
            "mass above 0");
  EXPECT_EQ(Complaint(SmallRobot{.inertial = R"(<inertial><mass value="1"/>
      <inertia ixx="1" iyy="1" izz="-1" ixy="0" ixz="0" iyz="0"/></inertial>)"}
                          .Text()),
            "r.urdf:4: <link name=\"arm\">: inertia is not positive definite, expected that of a "
            "body");
}

TEST_F(UrdfReader, RefusesWhatItCannotBuild) {
  EXPECT_EQ(Complaint(SmallRobot{.type = "planar"}.Text()),
            "r.urdf:7: <joint name=\"turn\">: this type of joint is not supported, expected "
            "revolute, continuous, prismatic or fixed");
}

TEST_F(UrdfReader, TurnsOnAndOnWhatHasNoLimits) {
  const RobotModel model =
      Read(SmallRobot{.limit = R"(<limit velocity="3" effort="4"/>)", .type = "continuous"}.Text());
  EXPECT_EQ(model.links[0].joint_type, scene::JointType::kRevolute);
  EXPECT_GT(model.links[0].upper, 1000 * 2 * std::numbers::pi);
  EXPECT_EQ(model.links[0].lower, -model.links[0].upper);
  EXPECT_EQ(model.links[0].max_velocity, 3);
}

TEST_F(UrdfReader, RefusesLinksThatAreNoTree) {
  const std::string loop = R"(<robot name="r">
<link name="base"/>
<link name="a"/><link name="b"/>
<joint name="ab" type="fixed"><parent link="a"/><child link="b"/></joint>
<joint name="ba" type="fixed"><parent link="b"/><child link="a"/></joint></robot>)";
  EXPECT_EQ(Complaint(loop),
            "r.urdf:3: <link name=\"a\">: hangs in a loop of joints, expected a tree");
  const std::string two_parents = R"(<robot name="r">
<link name="base"/><link name="a"/>
<joint name="x" type="fixed"><parent link="base"/><child link="a"/></joint>
<joint name="y" type="fixed"><parent link="base"/><child link="a"/></joint></robot>)";
  EXPECT_EQ(Complaint(two_parents),
            "r.urdf:2: <link name=\"a\">: is the child of two joints, expected one at most");
  const std::string two_roots = R"(<robot name="r">
<link name="base"/>
<link name="lost"/></robot>)";
  EXPECT_NE(Complaint(two_roots).find("r.urdf:2: "), std::string::npos) << Complaint(two_roots);
}

TEST_F(UrdfReader, RefusesAJointToALinkThatIsNotThere) {
  const std::string message = Complaint(R"(<robot name="r">
<link name="base"/>

<joint name="x" type="fixed"><parent link="base"/><child link="ghost"/></joint></robot>)");
  EXPECT_TRUE(message.starts_with("r.urdf:4: ")) << message;
  EXPECT_NE(message.find("ghost"), std::string::npos) << message;
}

TEST_F(UrdfReader, RefusesTextThatIsNoUrdf) {
  EXPECT_EQ(Complaint(""), "r.urdf:1: found an empty file, expected a <robot> element");
  EXPECT_EQ(Complaint("hello"),
            "r.urdf:1: found something that is not XML, expected a <robot> element");
  EXPECT_TRUE(Complaint("<scene/>").starts_with("r.urdf: "));
  EXPECT_TRUE(Complaint("<robot/>").starts_with("r.urdf: "));
  for (const char* broken : {"<link name=base/></robot>", "<!-- <link/>", "<link></lnk></robot>"}) {
    const std::string message = Complaint("<robot name=\"r\">\n" + std::string(broken));
    EXPECT_TRUE(message.starts_with("r.urdf:2: found an error in the XML (")) << message;
  }
  EXPECT_EQ(Complaint(std::string("<robot\n\0/>", 10)),
            "r.urdf:2: found a NUL byte, expected XML text in UTF-8");
  EXPECT_EQ(Complaint("<!DOCTYPE robot [<!ENTITY a \"b\">]><robot name=\"r\"/>"),
            "r.urdf:1: found a DOCTYPE, expected none: files must be self-contained");
}

TEST_F(UrdfReader, ReadsWhatOtherToolsLeaveBehind) {
  const std::string plain = SmallRobot().Text();
  const std::string extra = R"(
  <!-- ---- of a simulator ---- -->
  <gazebo><controller:gazebo_ros name="c"><updateRate>100 Hz</updateRate></controller:gazebo_ros>
    <plugin name="p"><![CDATA[ <link name="arm"/> ]]></plugin></gazebo>)";
  EXPECT_EQ(Read(SmallRobot{.extra = extra}.Text()).links, Read(plain).links);
  const std::string latin = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<!-- \xE9 -->";
  EXPECT_EQ(Read(latin + plain.substr(plain.find('\n'))).links, Read(plain).links);
}

TEST_F(UrdfReader, RefusesTagsThatOnlyItsParserWouldSee) {
  EXPECT_EQ(
      Complaint("<robot name=\"r\">\n<?note > <a><a> ?></robot>"),
      "r.urdf:2: found the processing instruction \"note\" with < or > inside, expected none");
}

TEST_F(UrdfReader, BoundsDepthAndSize) {
  std::string deep = "<robot name=\"r\">";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_EQ(Complaint(deep),
            "r.urdf:1: <a>: found more than 32 elements inside one another, expected fewer");

  const auto repeated = [](const std::string& before, const std::string& after, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += before + std::to_string(i) + after;
    return text;
  };
  EXPECT_EQ(Complaint("<robot name=\"r\">" + repeated("<link name=\"l", "\"/>", 257) + "</robot>"),
            "r.urdf: found 257 elements <link>, expected 256 at most");
  EXPECT_EQ(
      Complaint("<robot>" + repeated("<joint><child link=\"l", "\"/></joint>", 20000) + "</robot>"),
      "r.urdf: found 20000 elements <joint>, expected 256 at most");
  EXPECT_EQ(Complaint("<robot " + repeated("a", "=\"\" ", 100000) + "/>"),
            "r.urdf:1: found a tag with 100000 attributes, expected at most 32");
  EXPECT_EQ(Complaint("<robot>" + repeated("<a", "/>", 60000) + "</robot>"),
            "r.urdf:1: <a49999>: found more than 50000 elements, expected fewer");
}

TEST_F(UrdfReader, NamesTheMissingFile) {
  try {
    ReadRobot(folder_ / "none.urdf");
    FAIL() << "read a file that is not there";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), (folder_ / "none.urdf").string() + ": no such file");
  }
}

TEST_F(UrdfReader, PrintsNothing) {
  testing::internal::CaptureStderr();
  Complaint("<robot/>");
  Complaint(SmallRobot{.limit = ""}.Text());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace smile::robot
