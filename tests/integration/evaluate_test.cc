// Many runs, several brains, and whatever may happen to them meanwhile.

#include "program.h"

namespace smile {
namespace {

class Evaluate : public ProgramTest {
 protected:
  /// Shown is a block that is lifted and put back. In the scene it falls into its place, so that
  /// doing nothing succeeds.
  Evaluate() {
    Write("pair.xml", PairOfBlocks());
    Write("falls.xml", PairThatFallsIntoPlace());
    Write("lift.jsonl", LiftAndPutBack());
    Write("stack.jsonl", StackPair());
    EXPECT_EQ(Smile("run pair.xml --commands lift.jsonl --record lifted --no-pictures").exit_code,
              0);
    WriteBrain("idle", "");
  }

  /// Writes a program that logs the layout it was started with in started.txt, runs `lines`, and
  /// ends.
  void WriteBrain(const std::string& name, const std::string& lines) const {
    Write(name + "/" + name + ".py",
          "import os, signal, time\n"
          "supervisor = os.getppid()\n"
          "simulator = int(open(f'/proc/{supervisor}/stat').read().split(') ')[1].split()[1])\n"
          "words = open(f'/proc/{simulator}/cmdline').read().split('\\0')\n"
          "seed = int(words[words.index('--seed') + 1])\n"
          "open('" +
              directory_.string() +
              "/processes.txt', 'a').write(f'{os.getpid()} {supervisor} {simulator}\\n')\n"
              "def step(sensor, motor, aux):\n"
              "  open('" +
              directory_.string() + "/started.txt', 'a').write(f'" + name + " {seed}\\n')\n" +
              lines + "  aux.exit = 1\n");
  }

  Answer EvaluateOf(const std::string& demo, const std::string& arguments,
                    const std::string& scene = "falls.xml") const {
    return Smile("evaluate " + demo + " --scene " + scene + " --out ev --json " + arguments);
  }
  /// The layouts in which programs were started since it was asked last, sorted.
  std::string Started() const {
    return Shell("sort started.txt | tr '\\n' ';'; rm -f started.txt").out;
  }
};

TEST_F(Evaluate, CountsComparesAndRunsEachSeedOnce) {
  WriteBrain("other", "");
  const std::string arguments = "--brain idle/idle.py --brain other/other.py --seed 7";
  const Answer answer = EvaluateOf("lifted", arguments + " --scenes 3 --jobs 2");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json evaluation = answer.json();
  EXPECT_EQ(evaluation["brains"][0]["summary"]["successes"], 3);
  EXPECT_EQ(evaluation["brains"][1]["name"], "other");
  EXPECT_EQ(evaluation["brains"][1]["runs"][2]["seed"], 9);
  EXPECT_EQ(evaluation["comparisons"][0]["both"], 3);
  EXPECT_EQ(Started(), "idle 7;idle 8;idle 9;other 7;other 8;other 9;");
  EXPECT_FALSE(Exists("ev/idle/seed-0007/imitation"));  // successes are not kept
  EXPECT_EQ(Read("ev/evaluation.json"), answer.out);

  // The same question has the same answer, without a run; a longer one runs the rest.
  EXPECT_EQ(EvaluateOf("lifted", arguments + " --scenes 3").out, answer.out);
  EXPECT_EQ(Started(), "");
  const Json longer = EvaluateOf("lifted", arguments + " --scenes 4").json();
  EXPECT_EQ(longer["brains"][0]["runs"].size(), 4u);
  EXPECT_EQ(Started(), "idle 10;other 10;");
}

TEST_F(Evaluate, AChangedProgramStartsANewFolder) {
  ASSERT_EQ(EvaluateOf("lifted", "--brain idle/idle.py --scenes 1").exit_code, 0);
  const std::string before = Read("ev/idle/seed-0001/result.json");
  Started();
  WriteBrain("idle", "  pass\n");
  ASSERT_EQ(EvaluateOf("lifted", "--brain idle/idle.py --scenes 1").exit_code, 0);
  EXPECT_EQ(Started(), "idle 1;");
  EXPECT_EQ(Read("ev/idle.1/seed-0001/result.json"), before);
}

TEST_F(Evaluate, ComparesDemonstratorsInCopiesThatItKeeps) {
  ASSERT_EQ(
      Smile("run pair.xml --commands lift.jsonl --record shown --size 160x120 --rate 4").exit_code,
      0);
  // It kills the simulator if the demonstration contains a visible demonstrator or texts.
  WriteBrain("shy",
             "  if 'forearm' in open(aux.demonstration + '/demo.json').read() or "
             "os.path.exists(aux.demonstration + '/0.txt'):\n"
             "    os.kill(simulator, signal.SIGKILL); time.sleep(60)\n");
  const std::string arguments = "--brain shy/shy.py --demonstrators invisible,forearm --scenes 2";
  const Answer answer = EvaluateOf("shown", arguments + " --no-symbols");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json evaluation = answer.json();
  EXPECT_EQ(evaluation["brains"][1]["name"], "shy.forearm");
  EXPECT_EQ(evaluation["brains"][1]["demonstrator"], "forearm");
  EXPECT_EQ(evaluation["comparisons"].size(), 1u);
  EXPECT_EQ(evaluation["comparisons"][0]["only_first"], 2);
  EXPECT_EQ(Started(), "shy 1;shy 1;shy 2;shy 2;");

  // The copies are made once; with texts they are others, and so are the results.
  const auto drawn = [this] { return Shell("stat -c %Y.%y ev/demonstrators/forearm/0/0.png").out; };
  const std::string before = drawn();
  EXPECT_EQ(EvaluateOf("shown", arguments + " --no-symbols").out, answer.out);
  EXPECT_EQ(Started(), "shy 1;shy 2;");  // those that crashed
  EXPECT_EQ(drawn(), before);
  EXPECT_EQ(EvaluateOf("shown", arguments).json()["brains"][0]["summary"]["successes"], 0);
  EXPECT_TRUE(Exists("ev/demonstrators/forearm.1") && Exists("ev/shy.invisible.1"));
}

TEST_F(Evaluate, ACrashedOrHungRunIsAFailureWithACause) {
  WriteBrain("shaky",
             "  if seed == 1: os.kill(simulator, signal.SIGKILL); time.sleep(60)\n"
             "  if seed == 2: print('I give up', flush=True); os._exit(3)\n"
             "  if seed == 4: os.kill(simulator, signal.SIGSTOP); time.sleep(60)\n");
  ASSERT_EQ(Smile("run pair.xml --commands stack.jsonl --record stacked --no-pictures").exit_code,
            0);
  const std::string arguments = "--brain shaky/shaky.py --timeout 100 ";
  const Answer answer = EvaluateOf("stacked", arguments + "--scenes 3", "pair.xml");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  Json runs = answer.json()["brains"][0]["runs"];
  runs.push_back(
      EvaluateOf("stacked", arguments + "--seed 4 --scenes 1 --wall-seconds 1", "pair.xml")
          .json()["brains"][0]["runs"][0]);
  const std::pair<const char*, const char*> causes[] = {{"crashed", "signal 9"},
                                                        {"brain_failed", "exit code 3"},
                                                        {"never_taken", ""},
                                                        {"hung", "no end after 1 s"}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(runs[i]["cause"]["word"], causes[i].first);
    EXPECT_NE(runs[i]["cause"]["text"].get<std::string>().find(causes[i].second), std::string::npos)
        << runs[i];
    EXPECT_FALSE(runs[i]["success"]);
  }
  EXPECT_NE(Read("ev/shaky/seed-0002/log.txt").find("I give up"), std::string::npos);
  EXPECT_TRUE(Exists("ev/" + runs[2]["recording"].get<std::string>() + "/demo.json"));
  // What came to its end is not repeated; what was cut short is.
  Started();
  EXPECT_EQ(EvaluateOf("stacked", arguments + "--scenes 3", "pair.xml").exit_code, 0);
  EXPECT_EQ(Started(), "shaky 1;");
}

TEST_F(Evaluate, ACrashIsAFailureEvenIfTheGoalIsReached) {
  Write("crashes.py",
        "def step(sensor, motor, aux):\n"
        "  if sensor.simTime > 1: raise RuntimeError('no camera')\n");
  const Answer answer = EvaluateOf("lifted", "--brain crashes.py --scenes 2");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json crashes = answer.json()["brains"][0];
  EXPECT_EQ(crashes["summary"]["successes"], 0);
  for (const Json& run : crashes["runs"]) {
    EXPECT_EQ(run["score"], 1);
    EXPECT_EQ(run["success"], false);
    EXPECT_EQ(run["cause"]["word"], "brain_failed");
    EXPECT_NE(run["cause"]["text"].get<std::string>().find("no camera"), std::string::npos) << run;
  }
}

TEST_F(Evaluate, AnInterruptedEvaluationContinues) {
  WriteBrain("slow", "  while seed > 1 and not os.path.exists('" + (directory_ / "go").string() +
                         "'): time.sleep(0.02)\n");
  const std::string command =
      "evaluate lifted --scene falls.xml --out ev --brain slow/slow.py --scenes 3 --timeout 100";
  // SIGTERM reaches the evaluation only; its runs are in groups of their own.
  const Answer cut = Shell(
      SMILE_PROGRAM " " + command +
      " --jobs 1 & evaluation=$!\n"
      "for k in $(seq 1500); do grep -q 2 started.txt 2>/dev/null && break; sleep 0.02; done\n"
      "kill -TERM $evaluation\nwait $evaluation");
  EXPECT_EQ(cut.exit_code, 3);
  EXPECT_NE(cut.err.find("1 of 3 runs are done and kept"), std::string::npos) << cut.err;
  EXPECT_EQ(Shell("for id in $(cat processes.txt); do kill -0 $id && echo $id; done").out, "");
  EXPECT_EQ(Started(), "slow 1;slow 2;");
  const Answer second = Shell("flock --nonblock ev " SMILE_PROGRAM " " + command);
  EXPECT_EQ(second.exit_code, 3) << second.err;
  EXPECT_NE(second.err.find("ev: another evaluation is writing its results there"),
            std::string::npos)
      << second.err;
  EXPECT_FALSE(Exists("ev/evaluation.json"));

  Write("go", "");
  const Answer whole = Smile(command + " --json");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(whole.json()["brains"][0]["summary"]["successes"], 3);
  EXPECT_EQ(Started(), "slow 2;slow 3;");
}

TEST_F(Evaluate, ImpossiblePlansAreReportedBeforeAnyRun) {
  Write("one.xml", SceneOf("<block id=\"b\" color=\"blue\" location=\"(2, -3, 0.5)\"/>"));
  const std::pair<const char*, const char*> wrong[] = {
      {"lifted --scene falls.xml --brain nowhere", "nowhere"},
      {"lifted --scene one.xml --brain idle/idle.py", "'a'"},
      {"nowhere --scene falls.xml --brain idle/idle.py", "nowhere"}};
  for (const auto& [arguments, message] : wrong) {
    const Answer answer = Smile("evaluate --out ev " + std::string(arguments));
    EXPECT_EQ(answer.exit_code, 1) << arguments;
    EXPECT_NE(answer.err.find(message), std::string::npos) << answer.err;
  }
  const std::string idle = "evaluate lifted --scene falls.xml --brain idle/idle.py --out ev ";
  for (const char* arguments :
       {"--scenes 0", "--no-symbols", "--demonstrators absent", "--shard 3/2"}) {
    EXPECT_EQ(Smile(idle + arguments).exit_code, 2) << arguments;
  }
  EXPECT_FALSE(Exists("ev"));
}

}  // namespace
}  // namespace smile
