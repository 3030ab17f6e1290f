#include <cmath>

#include "program.h"

namespace smile {
namespace {

class Run : public ProgramTest {
 protected:
  Run() {
    Write("pair.xml", PairOfBlocks());
    Write("stack.jsonl", StackPair());
  }
};

TEST_F(Run, SecondsAreExactTicks) {
  EXPECT_EQ(Smile("run pair.xml --seconds 5 --json").json()["ticks"], 300);
  const Json start = Smile("run pair.xml --seconds 0 --json").json();
  EXPECT_EQ(start["ticks"], 0);
  EXPECT_EQ(start["objects"]["b"]["position"], Json({2.0, -3.0, 0.5}));
  EXPECT_EQ(start["robot"]["left"]["joints"].size(), 7u);
}

TEST_F(Run, AScriptStacksABlock) {
  const Answer answer = Smile("run pair.xml --commands stack.jsonl --json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json position = answer.json()["objects"]["a"]["position"];
  EXPECT_NEAR(position[0].get<double>(), 2, 0.01);
  EXPECT_NEAR(position[2].get<double>(), 1.5, 0.01);
}

TEST_F(Run, WarnsOfWhatARobotUsesInVain) {
  const std::filesystem::path source(SMILE_SOURCE_DIR);
  const Answer answer =
      Smile("run '" + (source / "scenes/tower.xml").string() + "' --robot tern --commands '" +
            (source / "tests/golden/scripts/robot_cut.jsonl").string() + "'");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.err.find("warning: refused at "), std::string::npos) << answer.err;
  EXPECT_NE(answer.err.find(" s: there is nothing that 'Snips' can cut"), std::string::npos)
      << answer.err;
}

TEST_F(Run, RecordingPacingAndProcessesNeverChangeTheHash) {
  const auto hash = [this](const std::string& arguments) {
    return Smile("run pair.xml --commands stack.jsonl --json --seconds " + arguments)
        .json()["hash"];
  };
  const Json expected = hash("4");
  EXPECT_EQ(hash("4"), expected);
  EXPECT_EQ(hash("4 --record demo"), expected);
  EXPECT_EQ(hash("1 --realtime"), hash("1"));
}

TEST_F(Run, StdoutIsExactlyOneJsonObject) {
  const Answer answer = Smile("run pair.xml --seconds 1 --record demo --json");
  EXPECT_NO_THROW(answer.json()) << answer.out;
}

TEST_F(Run, WrongInputIsOneClearMessageAndExitCodeOne) {
  EXPECT_EQ(Smile("run nowhere.xml --seconds 1").exit_code, 1);
  Write("unknown.jsonl", "{\"hand\":\"left\",\"do\":\"grasp\",\"object\":\"z\"}\n");
  const Answer unknown = Smile("run pair.xml --commands unknown.jsonl");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_EQ(unknown.err, "unknown.jsonl:1: there is no object 'z'\n");

  Write("twice.jsonl",
        "{\"hand\":\"left\",\"do\":\"grasp\",\"object\":\"a\"}\n"
        "{\"hand\":\"left\",\"do\":\"grasp\",\"object\":\"a\"}\n");
  const Answer twice = Smile("run pair.xml --commands twice.jsonl");
  EXPECT_EQ(twice.exit_code, 1);
  EXPECT_EQ(twice.err, "twice.jsonl:2: the left hand already holds 'a'; release it first\n");
}

TEST_F(Run, WrongUseIsExitCodeTwo) {
  EXPECT_EQ(Smile("run pair.xml").exit_code, 2);
  EXPECT_EQ(Smile("run pair.xml --seconds -1").exit_code, 2);
  EXPECT_EQ(Smile("run pair.xml --seconds 1 --record x --size big").exit_code, 2);
  EXPECT_EQ(Smile("run pair.xml --seconds 1 --brain x --no-robot").exit_code, 2);
}

TEST_F(Run, AnUnwritablePlaceIsExitCodeThree) {
  const Answer answer = Smile("run pair.xml --seconds 1 --record /dev/null/demo");
  EXPECT_EQ(answer.exit_code, 3);
  EXPECT_NE(answer.err.find("/dev/null/demo"), std::string::npos) << answer.err;
}

TEST_F(Run, AMissingScriptIsWrongInputAndAFullStdoutIsTheMachinesNo) {
  const Answer missing = Smile("run pair.xml --commands nowhere.jsonl");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(missing.err, "nowhere.jsonl: no such file\n");
  EXPECT_EQ(Smile("run pair.xml --seconds 0 --json >/dev/full").exit_code, 3);
  EXPECT_EQ(Smile("run pair.xml --seconds nan").exit_code, 2);
}

TEST_F(Run, BytesThatAreNoTextNeverReachTheJson) {
  const Answer answer = Smile("check $'nope\\xff.xml' --json");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_FALSE(answer.json()["ok"]);
}

TEST_F(Run, AnArmPutAmongSleepingBlocksPushesThemAside) {
  const std::string pose = R"({"do":"joint_angles","left":[0.25,0.2,-1.527,2.4,1.529,1.3,0]})";
  Write("arm.jsonl",
        "{\"do\":\"wait\",\"seconds\":5}\n" + pose + "\n{\"do\":\"wait\",\"seconds\":1}\n");
  const Json tool =
      Smile("run pair.xml --commands arm.jsonl --json").json()["robot"]["left"]["end_effector"];
  // A block that sleeps just where the fingers will be.
  Write("there.xml", SceneOf("<block id=\"c\" xspan=\"2.2\" yspan=\"2.2\" zspan=\"" +
                             std::to_string(tool[2].get<double>()) + "\" location=\"(" +
                             std::to_string(tool[0].get<double>()) + "," +
                             std::to_string(tool[1].get<double>()) + "," +
                             std::to_string(tool[2].get<double>() / 2) + ")\"/>"));
  const Json before = Smile("run there.xml --seconds 5 --json").json()["objects"]["c"]["position"];
  const Json after =
      Smile("run there.xml --commands arm.jsonl --json").json()["objects"]["c"]["position"];
  EXPECT_GT(std::abs(before[0].get<double>() - after[0].get<double>()) +
                std::abs(before[1].get<double>() - after[1].get<double>()) +
                std::abs(before[2].get<double>() - after[2].get<double>()),
            0.02);
}

TEST_F(Run, TheSchemaIsJson) {
  EXPECT_EQ(Smile("commands --schema").json()["title"], "SMILE command");
  EXPECT_NE(Smile("commands").out.find("move_to: "), std::string::npos);
}

}  // namespace
}  // namespace smile
