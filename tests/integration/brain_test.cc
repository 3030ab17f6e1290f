#include "program.h"

namespace smile {
namespace {

class BrainAsUsed : public ProgramTest {
 protected:
  BrainAsUsed() { Write("pair.xml", PairOfBlocks()); }

  /// A folder `brain` whose callback is this.
  void WriteBrain(const std::string& callback, const std::string& init = "") const {
    Write("brain/agentBehavior.m",
          "function [init, callback] = agentBehavior()\n"
          "  init = @myInit;\n  callback = @myCallback;\nend\n");
    Write("brain/myInit.m", init + "\n");
    Write("brain/myCallback.m", callback + "\n");
  }
};

TEST_F(BrainAsUsed, MovesTheRobotAndItsRunReplaysWithoutIt) {
  WriteBrain(
      "motor.jointVelocities = [0.2 * ones(1, 7); zeros(1, 7)];\n"
      "motor.gripperVelocities = [-0.5; 0];\n"
      "if sensor.simTime >= 1, aux.exit = true; end",
      "aux.initJointAngles = [0.3 -0.4 0 0.9 0 1 0; -0.3 -0.4 0 0.9 0 1 0];");
  const Answer answer = Smile("run pair.xml --brain brain --record demo --json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json result = answer.json();
  EXPECT_EQ(result["brain"]["status"], "exited");
  EXPECT_EQ(result["ticks"], 60);
  EXPECT_NEAR(result["robot"]["left"]["joints"][0].get<double>(), 0.5, 0.01);
  EXPECT_NEAR(result["robot"]["right"]["joints"][0].get<double>(), -0.3, 1e-4);
  EXPECT_NEAR(result["robot"]["left"]["gripper"].get<double>(), 1.5, 0.02);
  std::filesystem::remove_all(directory_ / "brain");
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
}

TEST_F(BrainAsUsed, SeesAFreshPictureFourTimesASecond) {
  WriteBrain(
      "if isfield(sensor, 'rgbVision'), seen = seen + 1; size_seen = size(sensor.rgbVision); end\n"
      "if sensor.simTime >= 1.9, printf('%d %d %d %d\\n', seen, size_seen); aux.exit = 1; end",
      "seen = 0;");
  const Answer answer = Smile("run pair.xml --brain brain --size 64x48");
  EXPECT_NE(answer.err.find("8 48 64 3"), std::string::npos) << answer.err;
}

TEST_F(BrainAsUsed, AnErrorNamesFileAndLineAndKeepsTheRecording) {
  WriteBrain("x = 1;\nif sensor.simTime > 0.5\n  y = undefined_thing + 1;\nend");
  const Answer answer = Smile("run pair.xml --brain brain --record demo --json");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("brain/myCallback.m:3: "), std::string::npos) << answer.err;
  EXPECT_EQ(answer.json()["brain"]["status"], "failed");
  const Answer replay = Smile("replay demo --verify --json");
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_GE(replay.json()["ticks"], 30);
  const std::string log = Read("demo/commands.jsonl");
  EXPECT_NE(log.find("working"), std::string::npos) << "the face while it ran";
  EXPECT_NE(log.find("puzzled"), std::string::npos) << "the face when it failed";
}

TEST_F(BrainAsUsed, CrashesLoopsAndNonsenseHarmNobody) {
  WriteBrain("kill(getpid(), 9);");
  EXPECT_EQ(Smile("run pair.xml --brain brain --seconds 1 --record crash").exit_code, 1);
  EXPECT_EQ(Smile("replay crash --verify").exit_code, 0);

  WriteBrain("while true, end");
  const Answer loop = Smile("run pair.xml --brain brain --seconds 1 --record loop");
  EXPECT_EQ(loop.exit_code, 1);
  EXPECT_NE(loop.err.find("myCallback.m:1"), std::string::npos) << loop.err;

  WriteBrain("motor.jointVelocities = zeros(3, 3);");
  const Answer nonsense = Smile("run pair.xml --brain brain --seconds 1");
  EXPECT_EQ(nonsense.exit_code, 1);
  EXPECT_NE(nonsense.err.find("jointVelocities"), std::string::npos) << nonsense.err;
}

TEST_F(BrainAsUsed, ABrainThatDoesNotExistIsSaidSo) {
  const Answer answer = Smile("run pair.xml --brain nobody --seconds 1");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("nobody"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace smile
