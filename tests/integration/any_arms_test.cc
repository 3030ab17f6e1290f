// Robots of any number of arms and joints, driven by brains and commands the way a user does it.

#include <gtest/gtest.h>

#include "program.h"
#include "robot/test/generated_robot.h"

namespace smile {
namespace {

class AnyArms : public ProgramTest {
 protected:
  AnyArms() { Write("pair.xml", PairOfBlocks()); }

  void WriteRobot(const robot::GeneratedRobot& robot) {
    Write("robot.urdf", robot.Urdf());
    Write("robot.robot.json", robot.SideFile());
  }
  Answer RunBrain(const std::string& brain, const std::string& options = "") {
    return Smile("run pair.xml --robot robot.urdf --seconds 1 --json --no-pictures --brain " +
                 brain + " " + options);
  }

  /// Turns the last joint of each arm, as a chunk, and opens all grippers.
  static constexpr const char* kPython =
      "import numpy as np\n"
      "def init(aux):\n"
      "  for arm in aux.arms: arm.initJoints = [0.2] * len(arm.joints)\n"
      "def step(sensor, motor, aux):\n"
      "  for k, arm in enumerate(sensor.arms):\n"
      "    velocities = np.zeros((arm.joints.size, 10))\n"
      "    velocities[-1] = 0.3\n"
      "    motor.arms[k].velocities = velocities\n"
      "    if arm.gripper is not None: motor.arms[k].gripperVelocity = 0.2\n"
      "  aux.exit = sensor.simTime > 0.8\n";
  void WriteOctave() {
    Write("octave/agentBehavior.m",
          "function [a, b] = agentBehavior()\n  a = @begin;\n  b = @act;\nend\n");
    Write("octave/begin.m",
          "for k = 1:numel(aux.arms)\n"
          "  aux.arms(k).initJoints = 0.2 * ones(1, numel(aux.arms(k).joints));\nend\n");
    Write("octave/act.m",
          "for k = 1:numel(sensor.arms)\n"
          "  velocities = zeros(numel(sensor.arms(k).joints), 10);\n"
          "  velocities(end, :) = 0.3;\n"
          "  motor.arms(k).velocities = velocities;\n"
          "  if ~isempty(sensor.arms(k).gripper), motor.arms(k).gripperVelocity = 0.2; end\n"
          "end\n"
          "aux.exit = sensor.simTime > 0.8;\n");
  }
};

TEST_F(AnyArms, AreDrivenTheSameWayByPythonAndOctave) {
  Write("turn.py", kPython);
  WriteOctave();
  const std::vector<std::pair<robot::GeneratedRobot, std::vector<std::size_t>>> robots = {
      {robot::GeneratedRobot({{"ur", 6}}), {6}},
      {robot::GeneratedRobot({{"so", 5, /*has_gripper=*/false}}), {5}},
      {robot::ThreeArms(), {4, 6, 7}}};
  for (const auto& [robot, counts] : robots) {
    WriteRobot(robot);
    std::vector<Json> ends;
    for (const std::string brain : {"turn.py", "octave"}) {
      std::filesystem::remove_all(directory_ / "demo");
      const Answer answer = RunBrain(brain, "--record demo");
      ASSERT_EQ(answer.exit_code, 0) << answer.err;
      EXPECT_EQ(answer.json()["brain"]["status"], "exited") << answer.json()["brain"];
      EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
      ends.push_back(answer.json());
    }
    EXPECT_EQ(ends[0]["hash"], ends[1]["hash"]) << counts.size() << " arms";
    std::size_t k = 0;
    for (const auto& [name, arm] : ends[0]["robot"].items()) {
      if (name == "head") continue;
      ASSERT_EQ(arm["joints"].size(), counts[k]) << name;
      EXPECT_NEAR(arm["joints"].back().get<double>(), 0.45, 0.03) << name;
      EXPECT_NEAR(arm["joints"].front().get<double>(), 0.2, 0.01) << name;
      ++k;
    }
    EXPECT_EQ(k, counts.size());
  }
  EXPECT_NE(Read("demo/commands.jsonl").find(R"("arms":{"front":[)"), std::string::npos);
}

TEST_F(AnyArms, ArePlannedByBrains) {
  WriteRobot(robot::GeneratedRobot({{"so", 5}}));
  // Down onto a place in front of the robot, and then along a line.
  Write("reach.py",
        "import numpy as np\n"
        "from smile.motion import robot_of\n"
        "def init(aux):\n"
        "  aux.robot = robot = robot_of(aux)\n"
        "  assert robot.arms == ['so']\n"
        "  start = np.full(5, 0.5)\n"
        "  goal = np.array([[1.0, 0, 0, 0.5], [0, -1, 0, -4], [0, 0, -1, 2], [0, 0, 0, 1]])\n"
        "  across = np.array([[0.0, 0, 1, 0.5], [1, 0, 0, -4], [0, 1, 0, 2], [0, 0, 0, 1]])\n"
        "  assert robot.inverse('so', across, start) is None\n"
        "  assert 'arm of 5 joints' in robot.why_unreachable('so', across, start)\n"
        "  assert robot.inverse('so', across, start, any_rotation=True) is not None\n"
        "  q = robot.inverse('so', goal, start, any_turn=True)\n"
        "  goal[2, 3] = 1\n"
        "  aux.move, fault = robot.move_line('so', q, goal, tool_speed=2, any_turn=True)\n"
        "  assert fault is None, fault.reason\n"
        "  aux.arms[0].initJoints = q\n"
        "def step(sensor, motor, aux):\n"
        "  q, velocities = aux.move.at(sensor.simTime + aux.tickSeconds)\n"
        "  arm = sensor.arms[0]\n"
        "  motor.arms[0].velocities = (q - arm.joints) / aux.tickSeconds\n"
        "  aux.exit = sensor.simTime > aux.move.duration + 0.1\n"
        "  if aux.exit: print('at', np.round(arm.endEffector[:3, 3], 2).tolist())\n");
  Write("reach/agentBehavior.m",
        "function [a, b] = agentBehavior()\n  a = @begin;\n  b = @act;\nend\n");
  Write("reach/begin.m",
        "robot = smileRobot(aux);\n"
        "goal = [1 0 0 0.5; 0 -1 0 -4; 0 0 -1 2; 0 0 0 1];\n"
        "across = [0 0 1 0.5; 1 0 0 -4; 0 1 0 2; 0 0 0 1];\n"
        "[q, reason] = smileInverse(robot, robot.arms{1}, across, 0.5 * ones(1, 5));\n"
        "assert(isempty(q) && !isempty(strfind(reason, 'arm of 5 joints')));\n"
        "q = smileInverse(robot, 'so', goal, 0.5 * ones(1, 5), 'anyTurn', true);\n"
        "goal(3, 4) = 1;\n"
        "move = smileMoveLine(robot, 'so', q, goal, 'toolSpeed', 2, 'anyTurn', true);\n"
        "aux.arms(1).initJoints = q;\n");
  Write("reach/act.m",
        "q = smileSample(move, sensor.simTime + aux.tickSeconds);\n"
        "motor.arms(1).velocities = (q - sensor.arms(1).joints) / aux.tickSeconds;\n"
        "aux.exit = sensor.simTime > move.duration + 0.1;\n"
        "if aux.exit\n"
        "  printf('at [%g, %g, %g]\\n', round(100 * sensor.arms(1).endEffector(1:3, 4)) / 100);\n"
        "end\n");
  std::vector<Json> hashes;
  for (const std::string brain : {"reach.py", "reach"}) {
    const Answer answer = RunBrain(brain);
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_EQ(answer.json()["brain"]["status"], "exited") << answer.json()["brain"];
    EXPECT_NE(answer.err.find("brain: at [0.5, -4"), std::string::npos) << answer.err;
    hashes.push_back(answer.json()["hash"]);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_F(AnyArms, StopABrainThatIsWrittenForAnotherRobot) {
  WriteRobot(robot::ThreeArms());
  const Answer learner = RunBrain("'" + Shipped("matlab/examples/wave") + "'");
  EXPECT_NE(learner.exit_code, 0);
  EXPECT_NE(learner.err.find("aux.initJointAngles is for two arms of seven joints, but this robot "
                             "has front (4 joints), middle (6 joints), rear (7 joints): use "
                             "aux.arms(k).initJoints"),
            std::string::npos)
      << learner.err;
  Write("wrong.py",
        "def step(sensor, motor, aux):\n  motor.arms[1].velocities = [0.1, 0.2, 0.3]\n");
  EXPECT_NE(RunBrain("wrong.py")
                .err.find("wrong.py:2: ValueError: motor.arms[1].velocities is 3, expected 6"),
            std::string::npos);
}

TEST_F(AnyArms, AreMovedByCommandsAndExported) {
  WriteRobot(robot::ThreeArms());
  Write("move.jsonl",
        R"({"do":"joint_velocities","arms":{"rear":[0,0,0,0,0,0,0.5]},"grippers":{"rear":0.2}}
{"do":"wait","seconds":1}
{"do":"gripper","arm":"all","velocity":-0.1}
{"do":"wait","seconds":0.5}
)");
  const Answer run =
      Smile("run pair.xml --robot robot.urdf --commands move.jsonl --record demo --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NEAR(run.json()["robot"]["rear"]["gripper"].get<double>(), 0.15, 0.02);
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
  ASSERT_EQ(Smile("export demo --to trajectory-csv --arm rear --out rear.csv").exit_code, 0);
  EXPECT_TRUE(Read("rear.csv")
                  .starts_with("time,rear_j0,rear_j1,rear_j2,rear_j3,rear_j4,rear_j5,"
                               "rear_j6,rear_gripper\n"));
  const Answer unknown = Smile("export demo --to trajectory-csv --arm left --out left.csv");
  EXPECT_NE(unknown.exit_code, 0);
  EXPECT_NE(unknown.err.find("has no left, expected both, all, front, middle or rear"),
            std::string::npos)
      << unknown.err;
  Write("wrong.jsonl", R"({"do":"joint_velocities","arms":{"raer":[0,0,0,0,0,0,0.5]}})");
  EXPECT_NE(Smile("run pair.xml --robot robot.urdf --commands wrong.jsonl")
                .err.find("the robot has no arm \"raer\", expected front, middle or rear"),
            std::string::npos);
}

TEST_F(AnyArms, HaveLayoutsWithinTheirReach) {
  WriteRobot(robot::GeneratedRobot({{"ur", 6}}));
  const Answer layout =
      Smile("layout pair.xml --robot robot.urdf --seed 3 --out near.xml && cat near.xml");
  ASSERT_EQ(layout.exit_code, 0) << layout.err;
  const Answer baxter = Smile("layout pair.xml --seed 3 --out far.xml && cat far.xml");
  ASSERT_EQ(baxter.exit_code, 0) << baxter.err;
  EXPECT_NE(layout.out, baxter.out);
  WriteRobot(robot::GeneratedRobot({{"ur", 1}}));
  const Answer nowhere = Smile("layout pair.xml --robot robot.urdf --seed 3 --out nowhere.xml");
  EXPECT_NE(nowhere.exit_code, 0);
  EXPECT_NE(nowhere.err.find("within the robot's reach"), std::string::npos) << nowhere.err;
}

}  // namespace
}  // namespace smile
