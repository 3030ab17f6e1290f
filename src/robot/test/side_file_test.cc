#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "robot/test/robot_files.h"

namespace smile::robot {
namespace {

class SideFile : public RobotFiles {
 protected:
  /// A robot whose link `arm` carries the fingers `f1` and `f2`; its head pans.
  static std::string Urdf() {
    std::string fingers;
    for (const std::string name : {"f1", "f2"}) {
      fingers += "<link name=\"" + name + "\">" + SmallRobot().inertial + "</link><joint name=\"" +
                 name + "\" type=\"prismatic\"><parent link=\"arm\"/><child link=\"" + name +
                 "\"/><limit lower=\"0\" upper=\"0.1\" velocity=\"1\" effort=\"1\"/></joint>";
    }
    const std::string head = "<link name=\"face\">" + SmallRobot().inertial +
                             R"(</link><joint name="yaw" type="continuous"><parent link="base"/>
<child link="face"/><limit velocity="1" effort="1"/></joint>)";
    return SmallRobot{.extra = fingers + head}.Text();
  }
  static std::string WithArm(const std::string& more = "") {
    return R"({"format": 1,
"arms": {"only": {"joints": ["turn"], "tool": "arm", "fingers": ["f1", "f2"]}})" +
           more + "}";
  }
  std::string ComplaintAbout(const std::string& side_file) { return Complaint(Urdf(), side_file); }
};

TEST_F(SideFile, NamesArmsGrippersPosesAndTheStart) {
  const RobotModel model = Read(Urdf(), WithArm(R"(,
"head": {"joint": "yaw", "camera": "base"},
"never_collide": [["f1", "base"], ["f1", "f2"]],
"poses": {"up": {"only": [1.5], "opening": 0.1}}, "start": "up")"));
  ASSERT_EQ(model.arms.size(), 1u);
  const Arm& arm = model.arms[0];
  EXPECT_EQ(arm.name, "only");
  EXPECT_EQ(arm.joints, std::vector<int>{0});
  EXPECT_EQ(model.frames[arm.tool].name, "arm");
  EXPECT_EQ(arm.gripper, (Gripper{.left_finger = 1, .right_finger = 2}));
  EXPECT_EQ(model.head->joints, std::vector<int>{3});
  EXPECT_EQ(model.never_collide, (std::vector<std::pair<int, int>>{{-1, 1}, {1, 2}}));
  EXPECT_EQ(model.q_start, (std::vector<double>{1.5, 0.05, 0.05, 0}));
}

TEST_F(SideFile, MayBeReadWithAnotherStartWhichIsKept) {
  const std::string text = WithArm(R"(, "poses": {"up": {"only": [1.5], "opening": 0.1},
"low": {"only": [0.5], "opening": 0}}, "start": "up")");
  WriteFile(folder_ / "r.urdf", Urdf());
  const auto start_of = [&](const std::string& side_file, const std::string& pose) {
    const RobotReading read = LoadRobot(
        folder_ / "r.urdf", {.side_file_text = side_file, .start_pose = pose, .has_shapes = false});
    // The kept files are the robot as it begins.
    const RobotReading kept = LoadKeptRobot("r.urdf", "", [&](const auto& name, std::size_t) {
      const auto file = std::ranges::find(read.files, name, &RobotFile::name);
      return file == read.files.end() ? std::nullopt : std::optional(*file->bytes);
    });
    EXPECT_EQ(kept.model.q_start, read.model.q_start) << pose;
    return read.model.q_start[0];
  };
  EXPECT_EQ(start_of(text, "low"), 0.5);
  EXPECT_EQ(start_of(text, "absent"), 1.5);
  EXPECT_EQ(start_of(text, ""), 1.5);
}

TEST_F(SideFile, NamesPlacesTheUrdfHasNoNameFor) {
  const RobotModel model = Read(Urdf(), WithArm(R"(,
"frames": {"eye": {"on": "arm", "xyz": [1, 2, 3], "rpy": [0, 0, 1.5707963267948966]}},
"head": {"joint": "yaw", "camera": "eye"})"));
  const Frame& eye = model.frames[model.head->camera];
  EXPECT_EQ(eye.link, 0);
  EXPECT_EQ(eye.X_LF.translation(), Vector3(1, 2, 3));
  EXPECT_LT((eye.X_LF.rotation().col(0) - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "frames": {"arm": {"on": "base"}}})"),
            "r.robot.json: <frames/arm>: a link or frame of that name already exists");
}

TEST_F(SideFile, GivesContinuousJointsTheLimitsThatAreMissing) {
  const std::string urdf = SmallRobot{.limit = "", .type = "continuous"}.Text();
  EXPECT_EQ(
      Complaint(urdf),
      "r.urdf:7: <joint name=\"turn\">: has no <limit>, expected velocity and effort, here or "
      "as limits in a side file");
  const RobotModel model =
      Read(urdf, R"({"format": 2, "limits": {"turn": {"velocity": 2, "effort": 30}}})");
  EXPECT_EQ(model.links[0].max_velocity, 2);
  EXPECT_EQ(model.links[0].max_effort, 30);
  EXPECT_NE(Complaint(urdf, R"({"format": 2, "limits": {"turn": {"velocity": 2}}})"), "");
  EXPECT_NE(Complaint(urdf, R"({"format": 2, "limits": {"turn": {"velocity": 2, "effort": 1e9}}})"),
            "");
}

TEST_F(SideFile, MayBeMissing) {
  const RobotModel model = Read(Urdf());
  EXPECT_TRUE(model.arms.empty());
  EXPECT_FALSE(model.head.has_value());
}

TEST_F(SideFile, ComplaintsNameThePlace) {
  EXPECT_EQ(ComplaintAbout("[]"), "r.robot.json: found array, expected an object");
  EXPECT_EQ(ComplaintAbout("{}"), "r.robot.json: has no member \"format\"");
  EXPECT_EQ(ComplaintAbout(R"({"format": 3})"), "r.robot.json: <format>: found 3, expected 1 or 2");
  EXPECT_EQ(
      ComplaintAbout(WithArm(R"(, "posse": {})")),
      "r.robot.json: unknown member \"posse\", expected format, urdf_hashes, kinematics_hashes, "
      "ignore_mimics, frames, arms, grippers, gripper, head, limits, never_collide, poses, start, "
      "look or stands; did you mean "
      "\"poses\"?");
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a": {"joints": ["spin"], "tool": "arm"}}})"),
            "r.robot.json: <arms/a/joints/0>: found \"spin\", expected a joint that moves");
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a": {"joints": [7], "tool": "arm"}}})"),
            "r.robot.json: <arms/a/joints/0>: found number, expected a string");
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a": {"joints": [], "tool": "leg"}}})"),
            "r.robot.json: <arms/a/tool>: found \"leg\", expected the name of a link");
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "never_collide": [["arm", "arm"]])")),
            "r.robot.json: <never_collide/0>: both are the same rigid body, expected two links "
            "that move relative to each other");
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "start": "nowhere")")),
            "r.robot.json: <start>: found \"nowhere\", expected one of the poses");
  EXPECT_EQ(
      ComplaintAbout(WithArm(R"(, "gripper": "nix")")),
      "r.robot.json: <gripper>: found \"nix\", but there are no grippers, expected the member "
      "grippers");
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "ignore_mimics": ["turn"])")),
            "r.robot.json: <ignore_mimics/0>: found \"turn\", expected a joint that mimics another "
            "one");
}

TEST_F(SideFile, RefusesPayloadsThatAreNone) {
  for (const std::string payload : {"-1", "100001"}) {
    EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a":
{"joints": ["turn"], "tool": "arm", "payload": )" +
                             payload + "}}}"),
              "r.robot.json: <arms/a/payload>: found " + payload + ", expected 0 to 1e+05");
  }
}

TEST_F(SideFile, RefusesNamesOfArmsThatMeanSomethingElse) {
  const auto complaint = [&](const std::string& name) {
    return ComplaintAbout("{\"format\": 1, \"arms\": {\"" + name +
                          R"(": {"joints": ["turn"], "tool": "arm", "fingers": ["f1", "f2"]}}})");
  };
  const std::string place = "r.robot.json: <arms>: found the name ";
  for (const std::string name : {"", "a b", "x-y", "7th", "_a"}) {
    EXPECT_EQ(complaint(name),
              place + "\"" + name + "\", expected a letter, then letters, digits or _, 40 at most");
  }
  for (const std::string name : {"both", "any", "all", "head", "opening"}) {
    EXPECT_EQ(complaint(name),
              place + "\"" + name + "\", expected another than both, any, all, head or opening");
  }
  const std::string longest(40, 'a');
  EXPECT_EQ(complaint(longest), "");
  EXPECT_NE(complaint(longest + "a"), "");
  std::string urdf = Urdf();
  urdf.replace(urdf.find("\"yaw\""), 5, "\"only_gripper\"");
  EXPECT_EQ(Complaint(urdf, WithArm()),
            "r.robot.json: <arms/only>: there is a joint \"only_gripper\", expected that name for "
            "the gripper only");
}

TEST_F(SideFile, RefusesMoreThanSixteenArmsOrJointsOfAnArm) {
  const auto arms = [&](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      text += (i == 0 ? "\"" : ", \"") + ("a" + std::to_string(i)) + "\": {}";
    }
    return ComplaintAbout("{\"format\": 1, \"arms\": {" + text + "}}");
  };
  EXPECT_EQ(arms(17), "r.robot.json: <arms>: found 17, expected at most 16");
  EXPECT_EQ(arms(16), "r.robot.json: <arms/a0>: has no member \"joints\"");
  const auto joints = [&](int count) {
    std::string text = "\"turn\"";
    for (int i = 1; i < count; ++i) text += ", \"turn\"";
    return ComplaintAbout("{\"format\": 1, \"arms\": {\"a\": {\"joints\": [" + text +
                          "], \"tool\": \"arm\"}}}");
  };
  EXPECT_EQ(joints(17), "r.robot.json: <arms/a/joints>: found 17, expected at most 16");
  EXPECT_TRUE(joints(16).starts_with("r.robot.json: <arms/a/joints/1>: joint \"turn\" is already"));
}

TEST_F(SideFile, RefusesJointsThatTwoMove) {
  const auto complaint = [](const std::string& place, const std::string& joint) {
    return "r.robot.json: <" + place + ">: joint \"" + joint +
           "\" is already used, expected each joint once: in an arm, as a finger or in the head";
  };
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a":
{"joints": ["turn", "turn"], "tool": "arm"}}})"),
            complaint("arms/a/joints/1", "turn"));
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a": {"joints": ["turn"], "tool": "arm"},
"b": {"joints": ["turn"], "tool": "arm"}}})"),
            complaint("arms/b/joints/0", "turn"));
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a":
{"joints": ["f2"], "tool": "f2", "fingers": ["f1", "f2"]}}})"),
            complaint("arms/a/fingers/1", "f2"));
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "head": {"joint": "turn", "camera": "arm"})")),
            complaint("head/joint", "turn"));
}

TEST_F(SideFile, RefusesArmsThatAreNoChain) {
  const auto complaint = [](const std::string& place, const std::string& name,
                            const std::string& last) {
    return "r.robot.json: <arms/a/" + place + ">: found \"" + name +
           "\", which is not attached to joint \"" + last +
           "\", expected one after it in the chain: joints in order from the shoulder to the "
           "wrist, then the gripper";
  };
  const auto arm = [](const std::string& text) {
    return R"({"format": 1, "arms": {"a": )" + text + "}}";
  };
  EXPECT_EQ(ComplaintAbout(arm(R"({"joints": ["turn", "f1"], "tool": "f1"})")), "");
  EXPECT_EQ(ComplaintAbout(arm(R"({"joints": ["f1", "turn"], "tool": "f1"})")),
            complaint("joints/1", "turn", "f1"));
  EXPECT_EQ(ComplaintAbout(arm(R"({"joints": ["f1", "f2"], "tool": "f2"})")),
            complaint("joints/1", "f2", "f1"))
      << "side by side";
  EXPECT_EQ(ComplaintAbout(arm(R"({"joints": ["turn"], "tool": "base"})")),
            complaint("tool", "base", "turn"));
  EXPECT_EQ(ComplaintAbout(arm(R"({"joints": ["yaw"], "tool": "arm"})")),
            complaint("tool", "arm", "yaw"));
  EXPECT_EQ(ComplaintAbout(arm(R"({"joints": ["yaw"], "tool": "face", "fingers": ["f1", "f2"]})")),
            complaint("fingers/0", "f1", "yaw"));
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "grippers": {"g": {}}, "gripper": "g",
"arms": {"a": {"joints": ["turn"], "flange": "face"}}})"),
            complaint("flange", "face", "turn"));
}

TEST_F(SideFile, RefusesAppearancesThatAreUnknownOrDoNotFit) {
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "look": "baxer")")),
            "r.robot.json: <look>: unknown appearance \"baxer\", expected baxter; did you mean "
            "\"baxter\"?");
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "look": "baxter")")),
            "r.robot.json: <look>: the robot has no link \"torso\"");
}

TEST_F(SideFile, RefusesFingersThatAreNone) {
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a":
{"joints": [], "tool": "arm", "fingers": ["f1", "turn"]}}})"),
            "r.robot.json: <arms/a/fingers>: joint \"turn\" does not slide from 0, expected a "
            "finger that slides from 0");
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a":
{"joints": [], "tool": "arm", "fingers": ["f1"]}}})"),
            "r.robot.json: <arms/a/fingers>: length is 1, expected 2");
}

TEST_F(SideFile, RefusesPosesTheRobotCannotTake) {
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "poses": {"p": {"only": [3]}})")),
            "r.robot.json: <poses/p/only/0>: joint \"turn\" would be at 3, expected -1 to 2");
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "poses": {"p": {"only": [0, 0]}})")),
            "r.robot.json: <poses/p/only>: length is 2, expected 1");
  EXPECT_EQ(ComplaintAbout(WithArm(R"(, "poses": {"p": {"tail": 1}})")),
            "r.robot.json: <poses/p/tail>: expected the name of an arm, head or opening");
}

TEST_F(SideFile, ReportsWhereItIsNotJson) {
  EXPECT_EQ(ComplaintAbout("{\"format\": 1,\n\"arms\": }"),
            "r.robot.json: this is not JSON from line 2 on");
  EXPECT_EQ(ComplaintAbout(R"({"format": 1, "arms": {"a": {}, "a": {}}})"),
            "r.robot.json: the key \"a\" appears twice in \"arms\"");
}

}  // namespace
}  // namespace smile::robot
