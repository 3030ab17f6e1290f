// The descriptions of `smile describe`, and the reasons for failure that `smile imitate` reports.

#include "program.h"

namespace smile {
namespace {

class Describe : public ProgramTest {};

TEST_F(Describe, ReportsTheOrderOfConstruction) {
  ASSERT_EQ(Smile("run '" + Shipped("scenes/um.xml") + "' --commands '" +
                  Shipped("examples/um.jsonl") + "' --no-robot --no-pictures --record um")
                .exit_code,
            0);
  const Answer answer = Smile("describe um");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(
      answer.out.starts_with("1. ShortPlank on the table\n"
                             "2. Red1 on ShortPlank\n"
                             "3. Green1 on ShortPlank\n"))
      << answer.out;
  EXPECT_TRUE(answer.out.ends_with("12. LongPlank on Green2, Blue2 and Magenta2\n")) << answer.out;

  const Json json = Smile("describe um --json").json();
  EXPECT_EQ(json["objects"].size(), 12u);
  EXPECT_EQ(json["order"].size(), 12u);
  EXPECT_EQ(json["relations"].size(), 14u);
  EXPECT_EQ(json["fixed"], false);
}

TEST_F(Describe, ASwitchIsATaskThatARobotCanMiss) {
  const std::string scene = "'" + Shipped("scenes/controls.xml") + "'";
  ASSERT_EQ(Smile("run " + scene + " --commands '" + Shipped("examples/scenes/controls.jsonl") +
                  "' --no-pictures --record shown")
                .exit_code,
            0);
  Write("idle.py", "def step(sensor, motor, aux): aux.exit = True\n");
  const Answer answer = Smile("imitate shown " + scene + " --brain idle.py --out out --json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json result = answer.json();
  EXPECT_FALSE(result["success"]);
  EXPECT_EQ(result["score"], 0);
  EXPECT_TRUE(result["errors"].empty());
  ASSERT_FALSE(result["effects"].empty());
  for (const Json& effect : result["effects"]) EXPECT_EQ(effect["achieved"], false);
  EXPECT_EQ(result["cause"]["word"], "effect_missing");
  EXPECT_EQ(result["work"], Json({{"grasps", 0}, {"retries", 0}}));
}

TEST_F(Describe, TheCauseOfAFailureIsPrintedEvenIfAllObjectsAreInPlace) {
  Write("pair.xml", PairOfBlocks());
  Write("falls.xml", PairThatFallsIntoPlace());
  Write("lift.jsonl", LiftAndPutBack());
  ASSERT_EQ(Smile("run pair.xml --commands lift.jsonl --record lifted --no-pictures").exit_code, 0);
  Write("idle.py", "def step(sensor, motor, aux): aux.exit = True\n");
  Write("crashes.py",
        "def init(aux): raise RuntimeError('no camera')\n"
        "def step(sensor, motor, aux): pass\n");
  const Answer done = Smile("imitate lifted falls.xml --brain idle.py --out idle");
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_TRUE(done.out.starts_with("success after ")) << done.out;
  EXPECT_EQ(std::ranges::count(done.out, '\n'), 2) << done.out;
  // What counts is what stands two seconds after the brain's end.
  const Answer early = Smile("imitate lifted falls.xml --brain idle.py --hold 0 --out early");
  EXPECT_TRUE(early.out.starts_with("failure after ")) << early.out;
  const Answer failed = Smile("imitate lifted falls.xml --brain crashes.py --out crashed");
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_TRUE(failed.out.starts_with("failure after ")) << failed.out;
  const std::string cause = Json::parse(Read("crashed/result.json"))["cause"]["text"];
  EXPECT_NE(failed.out.find("\n" + cause + "\n"), std::string::npos) << failed.out;
}

TEST_F(Describe, ASceneInWhichAllIsDoneIsRefused) {
  Write("pair.xml", PairOfBlocks());
  Write("lift.jsonl", LiftAndPutBack());
  ASSERT_EQ(Smile("run pair.xml --commands lift.jsonl --record lifted --no-pictures").exit_code, 0);
  Write("idle.py", "def step(sensor, motor, aux): aux.exit = True\n");
  const Answer answer = Smile("imitate lifted pair.xml --brain idle.py --out out");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_TRUE(answer.err.ends_with(
      "pair: is already as the demonstration left it, expected a scene in which there is something "
      "to do\n"))
      << answer.err;
  EXPECT_FALSE(Exists("out"));
}

}  // namespace
}  // namespace smile
