#include "catalog/known_robots.h"

#include <string>
#include <vector>

#include "base/json.h"
#include "catalog/robot_catalog.h"
#include "catalog/robot_check.h"
#include "catalog/test/made_urdf.h"

namespace smile::catalog {
namespace {

/// A joint of a description, and the link that it carries, with its place in the parent link.
struct Joint {
  std::string name, type, parent, child;
  std::string xyz = "0 0 0", rpy = "0 0 0", axis = "0 0 1";
  std::string range = R"(lower="-3" upper="3")";
  std::string more;  ///< elements of the joint
};

std::string TextOf(const std::string& root, const std::vector<Joint>& joints) {
  std::string text = "<robot name=\"made\">\n<link name=\"" + root + "\"/>\n";
  for (const Joint& joint : joints) {
    text += joint.type == "fixed" ? "<link name=\"" + joint.child + "\"/>\n"
                                  : LinkText(joint.child, "0.04 0.04 0.04", "0 0 0");
    text += "<joint name=\"" + joint.name + "\" type=\"" + joint.type + "\"><parent link=\"" +
            joint.parent + "\"/><child link=\"" + joint.child + "\"/><origin xyz=\"" + joint.xyz +
            "\" rpy=\"" + joint.rpy + "\"/><axis xyz=\"" + joint.axis + "\"/><limit " +
            joint.range + " velocity=\"2\" effort=\"50\"/>" + joint.more + "</joint>\n";
  }
  return text + "</robot>\n";
}

/// An arm of two joints and two fingers on a hand, which is fixed to the last link.
std::vector<Joint> SmallArm() {
  return {
      {"turn", "revolute", "base", "lower", "0 0 0.1"},
      {"bend", "revolute", "lower", "upper", "0.0825 0 0.316", "1.570796326794897 0 0"},
      {"mount", "fixed", "upper", "hand", "0 0 0.107", "0 0 -0.7853981633974483"},
      {"left", "prismatic", "hand", "l", "0 0 0.06", "0 0 0", "0 1 0", R"(lower="0" upper="0.04")"},
      {"right", "prismatic", "hand", "r", "0 0 0.06", "0 0 0", "0 -1 0",
       R"(lower="0" upper="0.04")", R"(<mimic joint="left"/>)"}};
}

/// Arm and hand of the FR3. Numbers: franka_description, robots/fr3/kinematics.yaml and
/// end_effectors/common/franka_hand.xacro. The Panda differs in the prefix of its names: `panda_`,
/// or `fer_` in newer releases.
std::vector<Joint> Franka(const std::string& prefix) {
  const std::string up = "1.570796326794897 0 0", down = "-1.570796326794897 0 0";
  const std::vector<std::pair<std::string, std::string>> places{
      {"0 0 0.333", "0 0 0"},    {"0 0 0", down}, {"0 -0.316 0", up}, {"0.0825 0 0", up},
      {"-0.0825 0.384 0", down}, {"0 0 0", up},   {"0.088 0 0", up}};
  std::vector<Joint> joints{{"base_joint", "fixed", "base", prefix + "link0"}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    joints.push_back({prefix + "joint" + std::to_string(i + 1), "revolute",
                      prefix + "link" + std::to_string(i), prefix + "link" + std::to_string(i + 1),
                      places[i].first, places[i].second, "0 0 1", R"(lower="-3" upper="4.5")"});
  }
  const std::string slide = R"(lower="0" upper="0.04")";
  joints.insert(
      joints.end(),
      {{prefix + "joint8", "fixed", prefix + "link7", prefix + "link8", "0 0 0.107"},
       {prefix + "hand_joint", "fixed", prefix + "link8", prefix + "hand", "0 0 0",
        "0 0 -0.7853981633974483"},
       {prefix + "finger_joint1", "prismatic", prefix + "hand", prefix + "leftfinger", "0 0 0.0584",
        "0 0 0", "0 1 0", slide},
       {prefix + "finger_joint2", "prismatic", prefix + "hand", prefix + "rightfinger",
        "0 0 0.0584", "0 0 0", "0 -1 0", slide, "<mimic joint=\"" + prefix + "finger_joint1\"/>"}});
  return joints;
}

/// Lengths of an arm of Universal Robots [m].
struct UrLengths {
  std::string shoulder, upper_arm, forearm, wrist_1, wrist_2, wrist_3;
};
/// Numbers: ur_description, config/ur5e/default_kinematics.yaml and config/ur5/….
const UrLengths kUr5e{"0.1625",
                      "-0.425",
                      "-0.3922",
                      "0.1333",
                      "-0.0997 -2.044881182297852e-11",
                      "0.09959999999999999 -2.042830148012698e-11"};
const UrLengths kUr5{"0.089159",
                     "-0.425",
                     "-0.39225",
                     "0.10915",
                     "-0.09465 -1.941303950897609e-11",
                     "0.0823 -1.688001216681175e-11"};
/// Joints and frames: ur_description, urdf/ur_macro.xacro.
std::vector<Joint> Ur(const UrLengths& lengths) {
  const std::string any = R"(lower="-6.28" upper="6.28")", z = "0 0 1", none = "0 0 0";
  return {{"base_joint", "fixed", "world", "base_link"},
          {"base_link-base_link_inertia", "fixed", "base_link", "base_link_inertia", none,
           "0 0 3.141592653589793"},
          {"shoulder_pan_joint", "revolute", "base_link_inertia", "shoulder_link",
           "0 0 " + lengths.shoulder, none, z, any},
          {"shoulder_lift_joint", "revolute", "shoulder_link", "upper_arm_link", none,
           "1.570796327 0 0", z, any},
          {"elbow_joint", "revolute", "upper_arm_link", "forearm_link", lengths.upper_arm + " 0 0",
           none, z, any},
          {"wrist_1_joint", "revolute", "forearm_link", "wrist_1_link",
           lengths.forearm + " 0 " + lengths.wrist_1, none, z, any},
          {"wrist_2_joint", "revolute", "wrist_1_link", "wrist_2_link", "0 " + lengths.wrist_2,
           "1.570796327 0 0", z, any},
          {"wrist_3_joint", "revolute", "wrist_2_link", "wrist_3_link", "0 " + lengths.wrist_3,
           "1.570796326589793 3.141592653589793 3.141592653589793", z, any},
          {"wrist_3-flange", "fixed", "wrist_3_link", "flange", none,
           "0 -1.5707963267948966 -1.5707963267948966"},
          {"flange-tool0", "fixed", "flange", "tool0", none,
           "1.5707963267948966 0 1.5707963267948966"}};
}

/// An arm of ALOHA. Numbers: interbotix_xsarm_descriptions, urdf/aloha_vx300s.urdf.xacro.
std::vector<Joint> Aloha() {
  const std::string any = R"(lower="-3.14158" upper="3.14158")", none = "0 0 0";
  const std::string x = "1 0 0", y = "0 1 0", z = "0 0 1", of = "aloha_vx300s/";
  return {
      {"waist", "revolute", of + "base_link", of + "shoulder_link", "0 0 0.079", none, z, any},
      {"shoulder", "revolute", of + "shoulder_link", of + "upper_arm_link", "0 0 0.04805", none, y,
       R"(lower="-1.85" upper="1.2566")"},
      {"elbow", "revolute", of + "upper_arm_link", of + "upper_forearm_link", "0.05955 0 0.3", none,
       y, R"(lower="-1.7628" upper="1.6057")"},
      {"forearm_roll", "revolute", of + "upper_forearm_link", of + "lower_forearm_link", "0.2 0 0",
       none, x, any},
      {"wrist_angle", "revolute", of + "lower_forearm_link", of + "wrist_link", "0.1 0 0", none, y,
       R"(lower="-1.8675" upper="2.234")"},
      {"wrist_rotate", "revolute", of + "wrist_link", of + "gripper_link", "0.069744 0 0", none, x,
       any},
      {"ee_arm", "fixed", of + "gripper_link", of + "ee_arm_link", "0.042825 0 0"},
      {"gripper", "continuous", of + "ee_arm_link", of + "gripper_prop_link", "0.005675 0 0", none,
       x, ""},
      {"ee_bar", "fixed", of + "ee_arm_link", of + "fingers_link", "0.025875 0 0"},
      {"left_finger", "prismatic", of + "fingers_link", of + "left_finger_link", none, none, y,
       R"(lower="0.021" upper="0.057")"},
      {"right_finger", "prismatic", of + "fingers_link", of + "right_finger_link", none, none, y,
       R"(lower="-0.057" upper="-0.021")", R"(<mimic joint="left_finger" multiplier="-1"/>)"}};
}

class KnownRobots : public MadeRobots {
 protected:
  std::filesystem::path Write(const std::string& text) {
    WriteFile(folder_ / "r.urdf", text);
    return folder_ / "r.urdf";
  }
  std::string HashOf(const std::string& text) {
    return KinematicsHash(
        robot::ReadRobot(Write(text), {.side_file_text = R"({"format": 2})", .has_shapes = false}));
  }
  std::string HashOf(const std::vector<Joint>& joints) { return HashOf(TextOf("base", joints)); }

  /// Returns the name of the side file that is found by kinematics; otherwise what was found.
  std::string FoundByKinematics(const std::string& text) {
    const std::optional<KnownRobot> known = FindKnownRobot(Write(text));
    if (!known) return "none";
    if (known->match == KnownRobot::Match::kContent) return "by content";
    return known->side_file.filename().string();
  }
};

TEST_F(KnownRobots, HaveHashesInTheirSideFiles) {
  for (const auto& entry : std::filesystem::directory_iterator(
           DataFile("robots/baxter.urdf").parent_path() / "known")) {
    const Json root = ParseJson(ReadFile(entry.path(), 1 << 20));
    EXPECT_EQ(root.at("format"), 2) << entry.path() << ": mimics are part of the kinematics";
    ASSERT_FALSE(root.at("kinematics_hashes").empty()) << entry.path();
    for (const char* member : {"urdf_hashes", "kinematics_hashes"}) {
      for (const Json& hash : root.value(member, Json::array())) {
        EXPECT_EQ(hash.get<std::string>().size(), 16u) << entry.path();
      }
    }
  }
}

TEST_F(KnownRobots, AreOtherContentWithAnyOtherByte) {
  EXPECT_EQ(UrdfHash("<robot/>"), UrdfHash("<robot/>"));
  EXPECT_NE(UrdfHash("<robot/>"), UrdfHash("<robot />"));
}

TEST_F(KnownRobots, HaveTheSameKinematicsWithOtherShapesMassesLimitsAndLinkNames) {
  const std::string hash = HashOf(SmallArm());
  std::string text = TextOf("base", SmallArm());
  const auto replace = [&text](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
  };
  replace("\"/>", "\"   />\n");
  replace("<box size=\"0.04 0.04 0.04\"", "<mesh filename=\"package://none/none.stl\"");
  replace("ixx=\"0.01\"", "ixx=\"0.02\"");
  replace("<mass value=\"1\"", "<mass value=\"2.5\"");
  replace("upper=\"3\" velocity=\"2\"", "upper=\"2.5\" velocity=\"9\"");
  replace("\"upper\"", "\"upper_arm\"");
  replace("1.570796326794897", "1.5708");
  replace("type=\"revolute\"", "type=\"continuous\"");
  replace("</robot>", "<material name=\"red\"><color rgba=\"1 0 0 1\"/></material></robot>");
  EXPECT_EQ(HashOf(text), hash);
}

TEST_F(KnownRobots, HaveTheSameKinematicsWithOtherFixedJoints) {
  std::vector<Joint> joints = SmallArm();
  joints[2] = {"flange", "fixed", "upper", "plate", "0 0 0.1", "0 0 -0.5"};
  joints.insert(joints.begin() + 3,
                {"another", "fixed", "plate", "hand", "0 0 0.007", "0 0 -0.2853981633974483"});
  joints.push_back({"mark", "fixed", "hand", "tool", "0 0 0.1"});
  EXPECT_EQ(HashOf(joints), HashOf(SmallArm()));
  // The base stands on something, at the same place.
  joints.insert(joints.begin(), {"foot", "fixed", "world", "base"});
  EXPECT_EQ(HashOf(TextOf("world", joints)), HashOf(SmallArm()));
}

TEST_F(KnownRobots, HaveOtherKinematicsWithAnotherJoint) {
  const std::string hash = HashOf(SmallArm());
  std::vector<Joint> joints = SmallArm();
  const auto with = [&](std::size_t i, auto member, const std::string& value) {
    std::vector<Joint> other = joints;
    other[i].*member = value;
    return HashOf(other);
  };
  EXPECT_NE(with(1, &Joint::xyz, "0.0825 0 0.3161"), hash);
  EXPECT_NE(with(1, &Joint::rpy, "1.575 0 0"), hash);
  EXPECT_NE(with(2, &Joint::xyz, "0 0 0.108"), hash) << "a fixed joint before those that move";
  EXPECT_NE(with(1, &Joint::axis, "0 0 -1"), hash);
  EXPECT_NE(with(0, &Joint::name, "spin"), hash);
  EXPECT_NE(with(0, &Joint::type, "prismatic"), hash);
  EXPECT_NE(with(3, &Joint::parent, "upper"), hash);
  EXPECT_NE(with(4, &Joint::more, ""), hash) << "no mimic";
  joints.pop_back();
  EXPECT_NE(HashOf(joints), hash);
}

TEST_F(KnownRobots, AreFoundByTheirKinematics) {
  EXPECT_EQ(FoundByKinematics(TextOf("base", Franka("fr3_"))), "fr3.robot.json");
  EXPECT_EQ(FoundByKinematics(TextOf("base", Franka("fer_"))), "fer.robot.json");
  EXPECT_EQ(FoundByKinematics(TextOf("base", Franka("panda_"))), "panda.robot.json");
  EXPECT_EQ(FoundByKinematics(TextOf("world", Ur(kUr5))), "ur5.robot.json");
  const std::string aloha = TextOf("aloha_vx300s/base_link", Aloha());
  EXPECT_EQ(FoundByKinematics(aloha), "aloha_vx300s.robot.json");
  EXPECT_EQ(FoundByKinematics(TextOf("world", Ur(kUr5e))), "ur5e.robot.json");
  EXPECT_EQ(FindRobot((folder_ / "r.urdf").string()).side_file.filename(), "ur5e.robot.json");
  EXPECT_EQ(FoundByKinematics(TextOf("base", SmallArm())), "none");
  EXPECT_EQ(FoundByKinematics("<robot/>"), "none");
}

TEST_F(KnownRobots, AreNotFoundIfTheSideFileDoesNotFit) {
  const std::string text = TextOf("base", Franka("fr3_"));
  std::string renamed = text;
  for (auto at = renamed.find("\"fr3_link3\""); at != std::string::npos;
       at = renamed.find("\"fr3_link3\"")) {
    renamed.replace(at, 11, "\"forearm\"");
  }
  EXPECT_EQ(FoundByKinematics(renamed), "none");
  std::vector<Joint> narrow = Franka("fr3_");
  narrow[4].range = R"(lower="-1" upper="0")";  // of joint 4, which bends by 2.36 in the pose ready
  EXPECT_EQ(FoundByKinematics(TextOf("base", narrow)), "none");
}

TEST_F(KnownRobots, ReachOverTheTable) {
  for (const auto& [root, joints] :
       {std::pair(std::string("base"), Franka("fr3_")), std::pair(std::string("world"), Ur(kUr5)),
        std::pair(std::string("world"), Ur(kUr5e)),
        std::pair(std::string("aloha_vx300s/base_link"), Aloha())}) {
    const std::filesystem::path urdf = Write(TextOf(root, joints));
    const robot::RobotReading reading =
        robot::LoadRobot(urdf, {.side_file = FindRobot(urdf.string()).side_file});
    EXPECT_EQ(
        CheckRobot(
            {.model = reading.model, .gap = reading.gap.value(), .height = reading.height.value()})
            .findings,
        std::vector<std::string>());
  }
}

}  // namespace
}  // namespace smile::catalog
