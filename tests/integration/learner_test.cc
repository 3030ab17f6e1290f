// The main job: shown a task, the robot does it from other starting positions.

#include "program.h"

namespace smile {
namespace {

class Learner : public ProgramTest {};

TEST_F(Learner, RebuildsTheDemonstratedLetters) {
  const Answer answer = Smile("experiment --out um --no-films --json --seed 20");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json result = answer.json();
  EXPECT_EQ(result["task"], "um");
  EXPECT_TRUE(result["success"]);
  EXPECT_EQ(result["goal"]["objects"].size(), 12u);
  EXPECT_LT(result["mean_error_mm"], 5);
  EXPECT_TRUE(result["order"]["kept"]);
  EXPECT_EQ(result["brain"]["status"], "exited");
  EXPECT_NE(Read("um/report.html").find("LongPlank"), std::string::npos);
  EXPECT_EQ(Smile("replay --verify um/imitation").exit_code, 0);
}

/// Records the demonstration of the tower, and imitates it in another layout.
class LearnerWithAnotherRobot : public Learner, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    ASSERT_EQ(Smile("run '" + Shipped("scenes/tower.xml") + "' --kinematic --commands '" +
                    Shipped("examples/tower.jsonl") + "' --record shown")
                  .exit_code,
              0);
  }
  Answer Imitate(const std::string& options) {
    return Smile("imitate shown '" + Shipped("scenes/tower_robot.xml") + "' --brain '" +
                 Shipped(GetParam()) + "' --out built --no-pictures --json " + options);
  }
};

TEST_P(LearnerWithAnotherRobot, BuildsTheTowerWithASingleArm) {
  const Answer answer = Imitate("--robot tern --seed 1");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(answer.json()["success"]);
  EXPECT_EQ(answer.json()["claim_right"], true);
  EXPECT_LT(answer.json()["mean_error_mm"], 5);
}

TEST_P(LearnerWithAnotherRobot, RefusesARobotWithoutAGripperForTheBlocks) {
  const Answer answer = Imitate("--gripper none");
  EXPECT_NE(answer.exit_code, 0);
  EXPECT_NE(answer.err.find("the robot has no gripper for blocks that are 1.00 units wide: found "
                            "left: none, right: none; expected one that opens at least 1.10 units"),
            std::string::npos)
      << answer.err;
}

INSTANTIATE_TEST_SUITE_P(Twins, LearnerWithAnotherRobot,
                         ::testing::Values("python/learner/learner.py", "matlab/learner"),
                         [](const auto& brain) {
                           return brain.index == 0 ? std::string("python") : std::string("octave");
                         });

/// A shipped task, and the folder or file of the learner that imitates it. Two tasks have other
/// tests: both learners build the tower in tests/learner/inputs_only_test.py, one the bridge in
/// docs/learner.md.
struct Lesson {
  const char* task;
  const char* brain;
  const char* layout = "--seed 1";
};

/// What a program does not do, it gets nothing for.
class IdleBrain : public ProgramTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(IdleBrain, GainsNothing) {
  Write("idle.py",
        "def step(sensor, motor, aux):\n"
        "  aux.exit, aux.claim = True, 'gave up: nothing was tried'\n");
  const Answer answer = Smile("experiment " + std::string(GetParam()) +
                              " --out out --no-films --json --brain idle.py");
  ASSERT_EQ(answer.exit_code, 1) << answer.err;
  const Json result = answer.json();
  EXPECT_EQ(result["gain"], 0);
  EXPECT_EQ(result["score"], result["score_at_start"]);
  EXPECT_EQ(result["brain"]["claim"], Json({{"done", false}, {"reason", "nothing was tried"}}));
  EXPECT_EQ(result["claim_right"], true);
}

INSTANTIATE_TEST_SUITE_P(Tasks, IdleBrain,
                         ::testing::Values("um", "tower", "row", "bridge", "box", "hatch",
                                           "drive"));

class LearnerOf : public ProgramTest, public ::testing::WithParamInterface<Lesson> {};

TEST_P(LearnerOf, DoesItInASceneItHasNeverSeen) {
  const auto& [task, brain, layout] = GetParam();
  const Answer answer = Smile("experiment " + std::string(task) + " --out out --no-films --json " +
                              layout + " --brain " + Shipped(brain));
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(answer.json()["success"]);
  EXPECT_EQ(answer.json()["claim_right"], true);
  EXPECT_LT(answer.json()["mean_error_mm"], 5);
}

INSTANTIATE_TEST_SUITE_P(Tasks, LearnerOf,
                         ::testing::Values(Lesson{"row", "python/learner/learner.py"},
                                           Lesson{"box", "python/learner/learner.py"},
                                           Lesson{"hatch", "matlab/learner", ""}),
                         [](const auto& lesson) {
                           const std::string brain = lesson.param.brain;
                           return std::string(lesson.param.task) +
                                  (brain.starts_with("python") ? "_python" : "_octave");
                         });

}  // namespace
}  // namespace smile
