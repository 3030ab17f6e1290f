// Robots of all kinds, the way a user brings them.

#include "program.h"

namespace smile {
namespace {

/// An arm of two joints on a post; its upper half is a mesh.
std::string ArmUrdf() {
  const std::string inertial =
      "<inertial><origin xyz=\"0 0 0.1\"/><mass value=\"1\"/><inertia ixx=\"0.01\" iyy=\"0.01\" "
      "izz=\"0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
  const std::string limit =
      "<limit lower=\"-2\" upper=\"2\" velocity=\"2\" effort=\"50\"/></joint>";
  const std::string mesh =
      "<geometry><mesh filename=\"package://arm_parts/wedge.obj\" "
      "scale=\"0.05 0.05 0.2\"/></geometry>";
  return "<robot name=\"arm\"><link name=\"post\"><collision><geometry><box size=\"0.1 0.1 0.1\"/>"
         "</geometry></collision></link>\n"
         "<joint name=\"turn\" type=\"revolute\"><parent link=\"post\"/><child link=\"lower\"/>"
         "<axis xyz=\"0 0 1\"/>" +
         limit + "<link name=\"lower\">" + inertial +
         "</link>\n<joint name=\"bend\" type=\"revolute\"><parent link=\"lower\"/>"
         "<child link=\"upper\"/><origin xyz=\"0 0 0.2\"/><axis xyz=\"0 1 0\"/>" +
         limit + "<link name=\"upper\">" + inertial + "<visual>" + mesh + "</visual><collision>" +
         mesh + "</collision></link></robot>";
}

std::string WedgeObj() {
  return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}

class AnyRobot : public ProgramTest {
 protected:
  AnyRobot() {
    Write("pair.xml", PairOfBlocks());
    Write("my/arm.urdf", ArmUrdf());
    Write("ws/arm_parts/wedge.obj", WedgeObj());
    Write("my/arm.robot.json",
          R"({"format": 1, "arms": {"left": {"joints": ["turn", "bend"], "tool": "upper"}},
"poses": {"up": {"left": [0, 0.1]}}, "start": "up", "stands": {"gap": 0.5, "height": 0}})");
    Write("wave.jsonl",
          "{\"do\":\"joint_velocities\",\"left\":[1,-0.5]}\n{\"do\":\"wait\",\"seconds\":1}\n");
  }
  static constexpr const char* kRobot = " --robot my/arm.urdf --path ws ";
};

TEST_F(AnyRobot, WithOneArmIsDrivenByAScript) {
  const Answer answer = Smile("run pair.xml --commands wave.jsonl --json" + std::string(kRobot));
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json joints = answer.json()["robot"]["left"]["joints"];
  EXPECT_NEAR(joints[0].get<double>(), 1, 0.01);
  EXPECT_NEAR(joints[1].get<double>(), -0.4, 0.01);
  // The tool's own joint is 0.2 m above the base.
  EXPECT_NEAR(answer.json()["robot"]["left"]["end_effector"][2].get<double>(), 2, 0.01);
  EXPECT_EQ(Smile("render pair.xml --out a.png --size 64x48" + std::string(kRobot)).exit_code, 0);

  std::filesystem::remove(directory_ / "my/arm.robot.json");
  const Answer brain = Smile("run pair.xml --brain '" + Shipped("matlab/learner") + "'" + kRobot);
  EXPECT_NE(brain.err.find("a brain drives the arms of a robot, and this simulation has none"),
            std::string::npos)
      << brain.err;
}

TEST_F(AnyRobot, WithoutASideFileIsLoadedWithAWarning) {
  std::filesystem::remove(directory_ / "my/arm.robot.json");
  const Answer answer = Smile("run pair.xml --seconds 0.1 --json" + std::string(kRobot));
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_EQ(
      answer.err,
      "my/arm.urdf: the robot has no side file and cannot move; `smile robots add` makes one\n");
  const Answer asked = Smile("run pair.xml --seconds 0.1 --gripper electric" + std::string(kRobot));
  EXPECT_EQ(asked.exit_code, 1);
  EXPECT_EQ(Smile("run pair.xml --seconds 0.1 --no-robot --robot my/arm.urdf").exit_code, 2);
}

TEST_F(AnyRobot, StaysInItsRecordingWhenItsFilesAreGone) {
  Write("elsewhere/notes.json", Read("my/arm.robot.json"));
  std::filesystem::remove(directory_ / "my/arm.robot.json");
  const Answer run = Smile(
      "run pair.xml --commands wave.jsonl --record demo --no-pictures "
      "--side-file elsewhere/notes.json" +
      std::string(kRobot));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* folder : {"my", "ws", "elsewhere"}) {
    std::filesystem::remove_all(directory_ / folder);
  }
  EXPECT_TRUE(Exists("demo/robot/packages/arm_parts/wedge.obj"));
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
  EXPECT_EQ(Smile("history demo").exit_code, 0);
  EXPECT_EQ(Smile("render demo --out end.png --size 64x48").exit_code, 0);
  EXPECT_EQ(Smile("edit demo --speed 2 --out edited --no-pictures").exit_code, 0);
  EXPECT_EQ(Smile("replay edited --verify").exit_code, 0);
  EXPECT_EQ(Smile("checkout demo --seconds 0.5").exit_code, 0);
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
  // What is kept is whole by itself.
  EXPECT_EQ(Smile("run pair.xml --seconds 0.1 --robot demo/robot/arm.urdf "
                  "--path demo/robot/packages")
                .err,
            "");
}

TEST_F(AnyRobot, IsFoundInOlderRecordings) {
  ASSERT_EQ(Smile("run pair.xml --seconds 0.2 --record demo --no-pictures" + std::string(kRobot))
                .exit_code,
            0);
  Write("my/arm.urdf", ArmUrdf());
  ASSERT_EQ(Shell("cd demo && sed -i 's|package://arm_parts/||g' robot/arm.urdf && "
                  "mv robot/arm.urdf robot.urdf && mv robot/arm.robot.json robot.robot.json && "
                  "mv robot/packages/arm_parts/wedge.obj . && rm -r robot && "
                  "sed -i '/\"urdf\"/d; /\"gripper\"/d; s/\\(\"height_m\": [0-9.]*\\),/\\1/' "
                  "demo.json")
                .exit_code,
            0);
  const Answer answer = Smile("replay demo --verify");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
}

TEST_F(AnyRobot, IsStoredInTheRecording) {
  ASSERT_EQ(Smile("run pair.xml --seconds 0.2 --record demo --no-pictures" + std::string(kRobot))
                .exit_code,
            0);
  ASSERT_EQ(Shell("sed -i 's|robot/arm.urdf|../my/arm.urdf|' demo/demo.json").exit_code, 0);
  EXPECT_EQ(Smile("replay demo").err,
            "demo/demo.json: <robot/urdf>: found \"../my/arm.urdf\", expected a file in robot/\n");
}

TEST_F(AnyRobot, GripperIsKeptInTheRecording) {
  const Answer run = Smile(
      "run pair.xml --seconds 0.2 --record demo --no-pictures --gripper electric-narrow --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NEAR(run.json()["robot"]["left"]["gripper"].get<double>(), 0.57, 0.005);
  EXPECT_NE(Read("demo/demo.json").find("\"electric-extended-narrow-2-paddle\""),
            std::string::npos);
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
}

}  // namespace
}  // namespace smile
