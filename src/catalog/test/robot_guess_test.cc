#include "catalog/robot_guess.h"

#include <algorithm>

#include "catalog/test/made_urdf.h"
#include "model/robot_placement.h"
#include "motion/articulation_probe.h"
#include "robot/kinematics.h"

namespace smile::catalog {
namespace {

/// Two fingers on the link `a6` that slide apart along y.
std::string Fingers() {
  const std::string size = "0.02 0.01 0.08";
  return LinkText("l", size, "0 0.005 0.04") + LinkText("r", size, "0 -0.005 0.04") +
         JointText("slide_l", "prismatic", "a6", "l", "0 0 0.14", "0 1 0",
                   R"(lower="0" upper="0.05")") +
         JointText("slide_r", "prismatic", "a6", "r", "0 0 0.14", "0 -1 0",
                   R"(lower="0" upper="0.05")", "<mimic joint=\"slide_l\"/>");
}

/// A jaw on the link `a6` that turns away from a fixed one, which is part of that link.
std::string OneJaw() {
  return "<link name=\"fixed_jaw\">"
         "<inertial><mass value=\"0.1\"/><inertia ixx=\"1e-4\" iyy=\"1e-4\" izz=\"1e-4\" ixy=\"0\" "
         "ixz=\"0\" iyz=\"0\"/></inertial><collision><origin xyz=\"0 -0.01 0.05\"/><geometry><box "
         "size=\"0.02 0.01 0.1\"/></geometry></collision></link>"
         "<joint name=\"fix\" type=\"fixed\"><parent link=\"a6\"/><child "
         "link=\"fixed_jaw\"/><origin "
         "xyz=\"0 0 0.12\"/></joint>" +
         LinkText("jaw", "0.02 0.01 0.1", "0 0.005 0.05") +
         JointText("grip", "revolute", "a6", "jaw", "0 -0.005 0.12", "-1 0 0",
                   R"(lower="0" upper="1")");
}

/// Two jaws on the link `a6`: the drive turns the left one, and the right one mimics it.
std::string TwoJaws() {
  return LinkText("l", "0.02 0.01 0.1", "0 0 0.05") + LinkText("r", "0.02 0.01 0.1", "0 0 0.05") +
         JointText("drive", "revolute", "a6", "l", "0 0.03 0.12", "1 0 0",
                   R"(lower="-0.5" upper="0.3")") +
         JointText("follower", "revolute", "a6", "r", "0 -0.03 0.12", "1 0 0",
                   R"(lower="-1" upper="1")", R"(<mimic joint="drive" multiplier="-1"/>)");
}

class RobotGuessTest : public MadeRobots {
 protected:
  /// Expects the tool of an arm at the start pose over the table, pointing down, nothing in
  /// overlap.
  static void ExpectReady(const robot::RobotModel& model) {
    ASSERT_NE(FindPose(model, "ready"), nullptr);
    EXPECT_EQ(model.q_start, FindPose(model, "ready")->q);
    for (const robot::Arm& arm : model.arms) {
      const RigidTransform X_BaseG = robot::FramePose(model, {}, model.q_start, arm.tool);
      EXPECT_LT((X_BaseG.rotation().col(2) + Vector3::UnitZ()).norm(), 0.01) << arm.name;
      EXPECT_GT(X_BaseG.translation().z(), 0) << arm.name;
      EXPECT_GT(X_BaseG.translation().x(), 0) << arm.name;
    }
    motion::ArticulationProbe probe(robot::MakeArticulationSpec(model, {}));
    EXPECT_EQ(probe.FirstOverlap(model.q_start), std::nullopt);
  }
};

TEST_F(RobotGuessTest, IgnoresAMimicOfAnArmAndSaysSo) {
  // A rod beside the arm, and a joint of the arm itself.
  const std::string rod =
      LinkText("rod") + JointText("rod", "revolute", "a1", "rod", "0 0.1 0.1", "0 1 0",
                                  R"(lower="-2" upper="2")", "<mimic joint=\"a2\"/>");
  const std::string level = LinkText("a7") + JointText("a7", "revolute", "a6", "a7", "0 0 0.14",
                                                       "0 0 1", R"(lower="-2" upper="2")",
                                                       "<mimic joint=\"a3\" multiplier=\"-1\"/>");
  const RobotGuess guess = Guess(ChainText("a", 6) + level + rod);
  for (const std::string note :
       {"joint rod mimics a2 of an arm: the mimic is ignored, the joint moves by itself",
        "joint a7 mimics a3 of an arm: the mimic is ignored, the joint moves by itself"}) {
    EXPECT_EQ(std::ranges::count(guess.notes, note), 1) << note;
  }
  const robot::RobotModel model = Read(guess);
  ASSERT_EQ(model.arms.size(), 1u);
  EXPECT_GE(model.arms[0].joints.size(), 6u);
}

TEST_F(RobotGuessTest, NamesTheUrdfWhoseMimicHasNoRange) {
  const std::string rod =
      LinkText("rod") + JointText("rod", "revolute", "a1", "rod", "0 0.1 0.1", "0 1 0",
                                  R"(lower="3" upper="4")", "<mimic joint=\"a2\"/>");
  try {
    Guess(ChainText("a", 6) + rod);
    ADD_FAILURE() << "took it";
  } catch (const InputError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        (folder_ / "r.urdf").string() +
            ": joint \"rod\" mimics \"a2\", and its limits allow that one only 3 to 4, expected a "
            "part of the range -2 to 2");
  }
}

TEST_F(RobotGuessTest, FindsAnArmWithTwoFingersAndAReadyPose) {
  const RobotGuess guess = Guess(ChainText("a", 6) + Fingers());
  const robot::RobotModel model = Read(guess);
  ASSERT_EQ(model.arms.size(), 1u);
  const robot::Arm& arm = model.arms[0];
  EXPECT_EQ(arm.name, "arm");
  EXPECT_EQ(arm.joints, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  ASSERT_TRUE(arm.gripper.has_value());
  EXPECT_EQ(model.links[arm.gripper->left_finger].joint_name, "slide_l");
  EXPECT_EQ(OpeningRangeOf(model, *arm.gripper).open, 0.1);
  // Between the fingers, a little inside of their tips.
  const RigidTransform& X_LG = model.frames[arm.tool].X_LF;
  EXPECT_LT((X_LG.translation() - Vector3(0, 0, 0.21)).norm(), 1e-5);
  ExpectReady(model);
  EXPECT_EQ(guess.side_file, Guess(ChainText("a", 6) + Fingers()).side_file);
}

TEST_F(RobotGuessTest, PrefersToolFramesWithUsualNamesThatPointOut) {
  const std::string frames =
      R"(<link name="tcp"/><joint name="t" type="fixed"><parent link="a6"/><child link="tcp"/>
<origin xyz="0 0 0.2"/></joint>)";
  EXPECT_EQ(Read(Guess(ChainText("a", 6) + Fingers() + frames)).frames.size(), 10u);
  const robot::RobotModel model = Read(Guess(ChainText("a", 6) + Fingers() + frames));
  EXPECT_EQ(model.frames[model.arms[0].tool].name, "tcp");
  std::string aside = frames;
  aside.replace(aside.find("0 0 0.2\""), 8, "0 0 0.2\" rpy=\"0 1.57 0\"");
  const robot::RobotModel other = Read(Guess(ChainText("a", 6) + Fingers() + aside));
  EXPECT_EQ(other.frames[other.arms[0].tool].name, "arm_tool");
}

TEST_F(RobotGuessTest, FindsAJawThatTurnsAgainstAFixedOne) {
  const robot::RobotModel model = Read(Guess(ChainText("a", 6) + OneJaw()));
  ASSERT_EQ(model.arms.size(), 1u);
  EXPECT_EQ(model.arms[0].joints.size(), 6u);
  ASSERT_TRUE(model.arms[0].gripper.has_value());
  const robot::Gripper& gripper = *model.arms[0].gripper;
  EXPECT_EQ(gripper.kind, robot::GripperKind::kJaws);
  EXPECT_EQ(model.links[gripper.drive].joint_name, "grip");
  EXPECT_EQ(std::min(gripper.left_finger, gripper.right_finger), 5) << "the palm";
  EXPECT_NEAR(OpeningRangeOf(model, gripper).closed, 0, 0.006);
  EXPECT_NEAR(OpeningRangeOf(model, gripper).open, 0.0875 * std::sin(1), 0.006);
  ExpectReady(model);
}

TEST_F(RobotGuessTest, FindsJawsThatMimicTheirDrive) {
  const robot::RobotModel model = Read(Guess(ChainText("a", 6) + TwoJaws()));
  ASSERT_TRUE(model.arms.at(0).gripper.has_value());
  const robot::Gripper& gripper = *model.arms[0].gripper;
  EXPECT_EQ(gripper.kind, robot::GripperKind::kJaws);
  EXPECT_EQ(JointsOf(model, gripper).size(), 2u);
  EXPECT_NE(gripper.left_finger, gripper.right_finger);
  // Negative positions of the drive open.
  EXPECT_GT(gripper.openings.front(), gripper.openings.back());
  EXPECT_NEAR(OpeningRangeOf(model, gripper).open, 0.05 + 2 * 0.0875 * std::sin(0.5), 0.02);
}

TEST_F(RobotGuessTest, FindsJawsBesideAJointThatNothingMimics) {
  // As those of a ViperX: fingers that slide from 0.021 to 0.057 m, and a horn of their motor.
  const std::string size = "0.08 0.01 0.02";
  const std::string jaws =
      LinkText("horn", "0.01 0.02 0.02", "0 0 0") + LinkText("l", size, "0.04 -0.01 0") +
      LinkText("r", size, "0.04 0.01 0") +
      JointText("gripper", "continuous", "a6", "horn", "0.05 0 0.12", "1 0 0", "") +
      JointText("left_finger", "prismatic", "a6", "l", "0.07 0 0.12", "0 1 0",
                R"(lower="0.021" upper="0.057")") +
      JointText("right_finger", "prismatic", "a6", "r", "0.07 0 0.12", "0 1 0",
                R"(lower="-0.057" upper="-0.021")",
                R"(<mimic joint="left_finger" multiplier="-1"/>)");
  const RobotGuess guess = Guess(ChainText("a", 6) + jaws);
  const robot::RobotModel model = Read(guess);
  ASSERT_TRUE(model.arms.at(0).gripper.has_value());
  const robot::Gripper& gripper = *model.arms[0].gripper;
  EXPECT_EQ(gripper.kind, robot::GripperKind::kJaws);
  EXPECT_EQ(model.links[gripper.drive].joint_name, "left_finger");
  EXPECT_EQ(JointsOf(model, gripper).size(), 2u);
  EXPECT_NEAR(OpeningRangeOf(model, gripper).closed, 2 * (0.021 - 0.015), 1e-4);
  EXPECT_NEAR(OpeningRangeOf(model, gripper).open, 2 * (0.057 - 0.015), 1e-4);
  EXPECT_NE(std::ranges::find(guess.notes, "arm: joint \"gripper\" moves no jaw; `turn` moves it"),
            guess.notes.end());
  ExpectReady(model);
}

TEST_F(RobotGuessTest, FindsASuctionCupByItsName) {
  const std::string cup =
      R"(<link name="suction_cup"/><joint name="t" type="fixed"><parent link="a6"/>
<child link="suction_cup"/><origin xyz="0 0 0.13"/></joint>)";
  const robot::RobotModel model = Read(Guess(ChainText("a", 6) + cup));
  ASSERT_TRUE(model.arms.at(0).gripper.has_value());
  EXPECT_EQ(model.arms[0].gripper->kind, robot::GripperKind::kSuction);
  EXPECT_EQ(model.frames[model.arms[0].tool].name, "suction_cup");
}

TEST_F(RobotGuessTest, FindsSeveralArmsOnATorso) {
  const std::string torso = LinkText("torso", "0.05 0.3 0.3", "0 0 0.2") +
                            JointText("lift", "prismatic", "base", "torso", "0 0 0.1", "0 0 1",
                                      R"(lower="0" upper="0.1")");
  const RobotGuess guess = Guess(torso + ChainText("p", 7, "torso", "0.1 -0.25 0.3") +
                                 ChainText("q", 6, "torso", "0.1 0.25 0.3"));
  const robot::RobotModel model = Read(guess);
  ASSERT_EQ(model.arms.size(), 2u);
  EXPECT_EQ(model.arms[0].name, "left");
  EXPECT_EQ(model.arms[0].joints.size(), 6u);
  EXPECT_EQ(model.arms[1].name, "right");
  EXPECT_EQ(model.arms[1].joints.size(), 7u);
  EXPECT_NE(std::ranges::find(guess.notes, "torso, which no arm contains: lift"),
            guess.notes.end());
}

TEST_F(RobotGuessTest, ListsLinksThatAlwaysOverlapAsTouchingByConstruction) {
  // The box of a5 reaches through a4 into a3.
  std::string chain = ChainText("a", 6);
  const std::string box = "size=\"0.04 0.04 0.1\"";
  chain.replace(chain.find(box, chain.find("<link name=\"a5\">")), box.size(),
                "size=\"0.04 0.04 0.6\"");
  const robot::RobotModel model = Read(Guess(chain));
  EXPECT_NE(std::ranges::find(model.never_collide, std::pair(2, 4)), model.never_collide.end());
}

TEST_F(RobotGuessTest, RefusesRobotsOfMoreThanSixteenArmsOrJointsOfAnArm) {
  std::string arms;
  for (int i = 0; i < 17; ++i) {
    const std::string name(1, static_cast<char>('a' + i));
    arms += ChainText(name, 3, "base", std::to_string(i) + " 0 0.1");
  }
  EXPECT_EQ(Complaint(arms), "r.urdf: found 17 arms, expected at most 16");
  EXPECT_EQ(Complaint(ChainText("a", 17)),
            "r.urdf: found a chain of 17 joints from \"a1\" to \"a17\", expected at most 16 in an "
            "arm");
}

TEST_F(RobotGuessTest, RefusesRobotsWithoutAnArm) {
  EXPECT_EQ(Complaint(ChainText("a", 1)),
            "r.urdf: found no arm among its 1 joints, expected a chain of two joints or more");
  EXPECT_EQ(Complaint(""),
            "r.urdf: found no arm among its 0 joints, expected a chain of two joints or more");
  EXPECT_EQ(
      Complaint(ChainText("a", 3) + JointText("back", "revolute", "a3", "a1", "0 0 0", "0 0 1")),
      "r.urdf:3: <link name=\"a1\">: is the child of two joints, expected one at most");
  EXPECT_EQ(Complaint(R"(<link name="m"><visual><geometry><mesh filename="no.stl"/></geometry>
</visual></link><joint name="j" type="fixed"><parent link="base"/><child link="m"/></joint>)"),
            "r.urdf:3: <link name=\"m\">: the mesh \"no.stl\": expected a file in the folder of "
            "the robot, in a --path folder or below these");
}

TEST_F(RobotGuessTest, CanBeCanceled) {
  const std::filesystem::path urdf = WriteUrdf(ChainText("a", 6));
  EXPECT_THROW(GuessRobot(urdf, {}, [](double, double) { return false; }), std::runtime_error);
}

}  // namespace
}  // namespace smile::catalog
