// Choices of grippers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/kinematics.h"
#include "robot/test/baxter.h"
#include "robot/test/robot_files.h"

namespace smile::robot {
namespace {

RobotReading BaxterWith(const std::string& gripper) {
  return LoadRobot(DataFile("robots/baxter.urdf"), {.gripper = gripper});
}

/// Opening between the fingers, closed and open [mm].
std::pair<double, double> OpeningsOf(const RobotModel& model) {
  const Gripper& gripper = model.arms.at(0).gripper.value();
  const double stroke =
      model.links[gripper.left_finger].upper + model.links[gripper.right_finger].upper;
  return {1000 * gripper.closed_opening, 1000 * (gripper.closed_opening + stroke)};
}

TEST(Grippers, TheClassicOneIsTheUsualOne) {
  EXPECT_EQ(Baxter(), BaxterWith("classic").model);
  EXPECT_EQ(BaxterWith("").gripper, "classic");
  const auto [closed, open] = OpeningsOf(Baxter());
  EXPECT_EQ(closed, 0);
  EXPECT_EQ(open, 200);
}

// Rethink Robotics' figures: the blade stands so far outwards of the finger's frame, whose slots
// are 9.5 mm apart; the face of the pad lies 8.1 mm inside the blade's middle.
TEST(Grippers, TheElectricOneOpensAsFarAsTheRealOne) {
  constexpr double kNarrow = 17.25, kWide = 55.03;  // [mm]
  for (const std::string width : {"narrow", "wide"}) {
    for (int slot = 1; slot <= 4; ++slot) {
      for (const std::string other : {"", "-standard", "-basic", "-round-standard"}) {
        const std::string name = "electric-" + width + "-" + std::to_string(slot) + other;
        const double offset = width == "narrow" ? kNarrow : kWide;
        const double expected = 2 * (offset + (slot - 1) * 9.5 - 11 - 8.1);
        const auto [closed, open] = OpeningsOf(BaxterWith(name).model);
        EXPECT_NEAR(closed, std::max(0.0, expected), 1e-6) << name;
        EXPECT_NEAR(open, expected + 41.666, 1e-6) << name;
      }
    }
  }
  const auto [closed, open] = OpeningsOf(BaxterWith("electric").model);
  EXPECT_EQ(std::lround(closed), 91);
  EXPECT_EQ(std::lround(open), 133) << "wide, in slot 2: for blocks of 100 mm";
}

TEST(Grippers, TheElectricOneReachesAsFarAsTheRealOne) {
  const auto tool_beyond_hand = [](const std::string& gripper, int arm) {
    const RobotModel model = BaxterWith(gripper).model;
    const auto frame = [&](int index) { return FramePose(model, {}, model.q_start, index); };
    const int hand = FindFrame(model, model.arms.at(arm).name + "_hand").value();
    return (frame(hand).inverse() * frame(model.arms.at(arm).tool)).translation();
  };
  for (int arm : {0, 1}) {
    EXPECT_LT((tool_beyond_hand("electric", arm) - Vector3(0, 0, 0.1577)).norm(), 1e-12);
    EXPECT_LT((tool_beyond_hand("electric-standard", arm) - Vector3(0, 0, 0.12)).norm(), 1e-12);
    EXPECT_LT(tool_beyond_hand("none", arm).norm(), 1e-12);
  }
}

TEST(Grippers, ChangeNothingBeforeTheHand) {
  const RobotModel classic = Baxter(), electric = BaxterWith("electric").model;
  ASSERT_EQ(classic.num_joints(), electric.num_joints());
  for (int joint = 0; joint < classic.num_joints(); ++joint) {
    EXPECT_EQ(classic.links[joint].joint_name, electric.links[joint].joint_name);
    EXPECT_TRUE(classic.links[joint].X_PJ == electric.links[joint].X_PJ ||
                classic.links[joint].joint_type == scene::JointType::kPrismatic);
  }
  EXPECT_EQ(BaxterWith("electric").gripper, "electric-extended-wide-2-paddle");
  EXPECT_FALSE(BaxterWith("none").model.arms.at(0).gripper.has_value());
  EXPECT_EQ(BaxterWith("none").model.num_joints(), classic.num_joints() - 4);
}

TEST(Grippers, AWishForAnotherOneIsAnswered) {
  const auto complaint = [](const std::string& gripper) {
    try {
      BaxterWith(gripper);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.find("robots/") + 7);
    }
    return std::string();
  };
  EXPECT_EQ(complaint("electrik"),
            "baxter.robot.json: <grippers>: found the choice \"electrik\", expected classic, "
            "electric or none; did you mean \"electric\"?");
  EXPECT_EQ(complaint("electric-huge"),
            "baxter.robot.json: <grippers/electric>: found the word \"huge\", expected one of "
            "each: extended or standard; wide or narrow; 2, 1, 3 or 4; paddle, basic or round");
  EXPECT_EQ(complaint("electric-wide-narrow"),
            "baxter.robot.json: <grippers/electric>: found the words \"wide\" and \"narrow\", "
            "expected one of them");
  EXPECT_EQ(complaint("electric-narrow-narrow"),
            "baxter.robot.json: <grippers/electric>: found the word \"narrow\" twice, expected it "
            "once");
  EXPECT_EQ(complaint("classic-wide"),
            "baxter.robot.json: <grippers/classic>: found the word \"wide\", expected no words "
            "after its name");
}

/// A robot with a flange and a gripper of one finger, in files of its own.
class OwnGripper : public RobotFiles {
 protected:
  static constexpr const char* kGripper = R"(<robot name="g"><link name="root"/>
<joint name="slide" type="prismatic"><parent link="root"/><child link="finger"/>
<limit lower="0" upper="0.1" velocity="1" effort="1"/></joint>
<link name="finger"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>)";

  std::string ComplaintAbout(const std::string& parts, const std::string& more = "") {
    WriteFile(folder_ / "g.urdf", kGripper);
    return Complaint(SmallRobot().Text(),
                     R"({"format": 1, "arms": {"a": {"joints": ["turn"], "flange": "arm"}},
"grippers": {"g": {"parts": [)" +
                         parts + "]" + more + R"(}}, "gripper": "g"})");
  }
};

TEST_F(OwnGripper, HangsOnTheFlangeWithTheArmsNameBeforeItsOwn) {
  EXPECT_EQ(ComplaintAbout(R"({"urdf": "g.urdf"})", R"(, "tool": "finger")"), "");
  const RobotModel model = ReadRobot(folder_ / "r.urdf");
  EXPECT_EQ(model.links.at(1).joint_name, "a_slide");
  EXPECT_EQ(model.frames.at(model.arms.at(0).tool).name, "a_finger");
}

TEST_F(OwnGripper, ComplaintsNameThePlace) {
  EXPECT_EQ(ComplaintAbout(R"({"urdf": "none.urdf"})"),
            "r.robot.json: <grippers/g/parts/0/urdf>: found \"none.urdf\": expected a file in the "
            "folder of the robot, in a --path folder or below these");
  EXPECT_EQ(ComplaintAbout(R"({"urdf": "g.urdf", "to": "palm"})"),
            "r.robot.json: <grippers/g/parts/0>: would be attached to \"a_palm\", expected the "
            "name of a link");
  EXPECT_EQ(ComplaintAbout(R"({"urdf": "g.urdf"}, {"urdf": "g.urdf", "to": "finger"})"),
            "g.urdf:2: <joint name=\"slide\">: joint \"a_slide\" already exists");
  EXPECT_EQ(ComplaintAbout(R"({"urdf": "g.urdf"})", R"(, "fingers": ["slide", "slide"])"),
            "r.robot.json: <grippers/g/fingers>: both are the same joint, expected two");
}

TEST_F(OwnGripper, TextsThatGrowWithoutEndAreRefused) {
  const auto complaint = [&](const std::string& name, const std::string& word,
                             const std::string& urdf) {
    return ComplaintAbout("{\"urdf\": \"" + urdf + "\"}",
                          R"(, "choices": {")" + name + R"(": [")" + word + "\"]}");
  };
  const auto expected_letters = [](const std::string& message, const std::string& count) {
    return message.ends_with(", expected at most " + count + " characters");
  };
  const std::string word(64, 'w'), place = "r.robot.json: <grippers/g";
  std::string full = "{n}";
  for (int i = 0; i < 4; ++i) full += full;
  EXPECT_EQ(complaint("n", "g", "{n}.urdf"), "");
  std::string message = complaint("n", word, full);  // 16 times 64
  EXPECT_TRUE(message.starts_with(place + ">: with the choice, a string becomes")) << message;
  EXPECT_TRUE(expected_letters(message, "1000")) << message;
  message = complaint("n", word + "w", "g.urdf");
  EXPECT_TRUE(message.starts_with(place + "/choices/n/0>: found")) << message;
  EXPECT_TRUE(expected_letters(message, "64")) << message;
  message = complaint(word + "w", "w", "g.urdf");
  EXPECT_TRUE(message.starts_with(place + "/choices>: found the name")) << message;
  EXPECT_TRUE(expected_letters(message, "64")) << message;
  message = ComplaintAbout(R"({"urdf": "g.urdf", "prefix": ")" + word + "w\"}");
  EXPECT_TRUE(message.starts_with(place + "/parts/0/prefix>: found")) << message;
  EXPECT_TRUE(expected_letters(message, "64")) << message;
}

/// An arm with the fingers of a published description: the right one moves downwards from 0 and
/// mimics the left one.
std::string MimicUrdf(const std::string& multiplier) {
  std::string fingers;
  for (const std::string name : {"l", "r"}) {
    const bool is_left = name == "l";
    fingers += "<link name=\"" + name + "\">" + SmallRobot().inertial + "</link><joint name=\"" +
               name + "\" type=\"prismatic\"><parent link=\"arm\"/><child link=\"" + name +
               "\"/><axis xyz=\"0 1 0\"/><limit velocity=\"5\" effort=\"20\" lower=\"" +
               (is_left ? "0" : "-0.020833") + "\" upper=\"" + (is_left ? "0.020833" : "0") +
               "\"/>" + (is_left ? "" : "<mimic joint=\"l\" multiplier=\"" + multiplier + "\"/>") +
               "</joint>";
  }
  return SmallRobot{.extra = fingers}.Text();
}

class MimicFingers : public RobotFiles {
 protected:
  static constexpr const char* kSideFile = R"({"format": 1, "limits": {"r": {"velocity": 0.1}},
"arms": {"a": {"joints": [], "tool": "arm", "fingers": ["l", "r"], "closed_opening": 0.015}},
"poses": {"p": {"opening": 0.035}}, "start": "p"})";
};

TEST_F(MimicFingers, OpenTogetherWhicheverWayTheirJointsRun) {
  const RobotModel model = Read(MimicUrdf("-1"), kSideFile);
  const Gripper gripper = model.arms[0].gripper.value();
  const scene::LinkSpec& right = model.links[gripper.right_finger];
  EXPECT_EQ(right.axis, Vector3(0, -1, 0));
  EXPECT_EQ(right.lower, 0);
  EXPECT_EQ(right.upper, 0.020833);
  EXPECT_EQ(right.max_velocity, 0.1);
  EXPECT_EQ(gripper.closed_opening, 0.015);
  EXPECT_NEAR(model.q_start[gripper.left_finger], 0.01, 1e-15);
  EXPECT_NEAR(model.q_start[gripper.right_finger], 0.01, 1e-15);
}

TEST_F(MimicFingers, AreTheOnlyOnesThatMayMimic) {
  const std::string complaint =
      "r.robot.json: joint \"r\" mimics \"l\", expected a mimic only between two fingers that open "
      "symmetrically";
  EXPECT_EQ(Complaint(MimicUrdf("-2"), kSideFile), complaint);
  EXPECT_EQ(Complaint(MimicUrdf("-1"), R"({"format": 1,
"arms": {"a": {"joints": ["l"], "tool": "l"}}})"),
            complaint);
  // Nothing moves them.
  EXPECT_EQ(Complaint(MimicUrdf("-2"), R"({"format": 1})"), "");
}

TEST_F(MimicFingers, LimitsOnlyBecomeNarrower) {
  EXPECT_EQ(Complaint(MimicUrdf("-1"), R"({"format": 1, "limits": {"l": {"velocity": 6}}})"),
            "r.robot.json: <limits/l/velocity>: found 6, expected 0 to 5, as the URDF has it");
  EXPECT_EQ(Complaint(MimicUrdf("-1"), R"({"format": 1, "limits": {"l": {"upper": 0}}})"),
            "r.robot.json: <limits/l>: it permits no motion, expected lower below upper, the "
            "others above 0");
}

}  // namespace
}  // namespace smile::robot
