// Brains that are slow, that fail, that run in a debugger.

#include "program.h"

namespace smile {
namespace {

class BrainTrouble : public ProgramTest {
 protected:
  BrainTrouble() { Write("pair.xml", PairOfBlocks()); }

  /// A program whose step is this.
  void WriteStep(const std::string& lines) const {
    Write("brain/think.py",
          "import os, signal, sys, time\nimport numpy as np\n"
          "def step(sensor, motor, aux):\n  motor.jointVelocities[0, 0] = 0.1\n" +
              lines);
  }

  /// The program waits for its brain, as `smile run ... --attach` says. Meanwhile a shell runs the
  /// line that the program printed, and types `typed` at the debugger's prompt. `before` has the
  /// printed line in `$line`.
  Answer Attached(const std::string& brain, const std::string& typed,
                  const std::string& before = "") const {
    Write("typed", typed);
    return Shell("timeout 60 " SMILE_PROGRAM
                 " run pair.xml --attach --record demo --seconds 0.1 --json --brain " +
                 brain +
                 " >result.json 2>stderr.txt & simulator=$!\n"
                 "for k in $(seq 600); do grep -q '^cd ' stderr.txt && break; sleep 0.05; done\n"
                 "line=$(grep '^cd ' stderr.txt)\n" +
                 before +
                 "(eval \"$line\") <typed >debugger.txt 2>&1\n"
                 "wait $simulator");
  }
};

TEST_F(BrainTrouble, EveryFailureLeavesARecordingThatReplays) {
  const std::pair<const char*, const char*> failures[] = {
      {"os.kill(os.getpid(), signal.SIGSEGV)", "signal 11"},
      {"os.kill(os.getpid(), signal.SIGSTOP)", "took longer than 0.4 s"},
      {"[None for _ in iter(int, 1)]", "took longer than 0.4 s"},
      {"motor.jointVelocities[0, 0] = np.nan", "expected a finite number"},
      {"os.write(3, b'x' * 100); os.write(4, b'x' * 100)", "brain/think.py"},
      {"os._exit(0)", "exit code 0"},
  };
  for (const auto& [line, message] : failures) {
    WriteStep(std::string("  if sensor.simTime > 0.2: ") + line + "\n");
    const bool is_late = std::string(message).starts_with("took longer");
    const Answer answer =
        Shell(std::string("rm -rf demo; smile run pair.xml --brain brain/think.py --timeout ") +
              (is_late ? "0.4" : "20") + " --seconds 2 --record demo --no-pictures --json");
    EXPECT_EQ(answer.exit_code, 1) << line;
    EXPECT_EQ(answer.json()["brain"]["status"], "failed") << line;
    EXPECT_NE(answer.json()["brain"]["message"].get<std::string>().find(message), std::string::npos)
        << answer.err;
    EXPECT_EQ(answer.json()["ticks"], 13 + 15) << line;
    EXPECT_EQ(Smile("replay demo --verify").exit_code, 0) << line;
  }
}

TEST_F(BrainTrouble, OutputAndErrorOfABrainAreKept) {
  WriteStep("  print('at', sensor.simTime)\n  if sensor.simTime > 0.03: lost\n");
  const Answer answer = Smile("run pair.xml --brain brain/think.py --record demo --seconds 1");
  EXPECT_EQ(answer.exit_code, 1);
  const std::string log = Read("demo/brain.log");
  EXPECT_TRUE(log.starts_with("at 0.0\nat 0.016666666666666666\n")) << log;
  EXPECT_TRUE(log.ends_with("brain/think.py:6: NameError: name 'lost' is not defined\n")) << log;
  EXPECT_NE(answer.err.find("brain: at 0.0\n"), std::string::npos) << answer.err;
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
}

TEST_F(BrainTrouble, ASlowBrainIsWaitedForAndItsLateTicksAreCounted) {
  WriteStep(
      "  aux.steps = getattr(aux, 'steps', -1) + 1\n"
      "  assert round(sensor.simTime * 60) == aux.steps\n"
      "  if aux.steps < 5: time.sleep(0.05)\n"
      "  if aux.steps == 19: print('all steps')\n");
  const Answer answer =
      Smile("run pair.xml --brain brain/think.py --seconds 0.3333333 --realtime --json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.err.find("brain: all steps"), std::string::npos) << answer.err;
  EXPECT_GE(answer.json()["late_ticks"], 5);
  EXPECT_GE(answer.json()["worst_delay"], 0.1);
}

TEST_F(BrainTrouble, ABrainEndsWithAKilledSimulator) {
  WriteStep(
      "  import subprocess\n"
      "  child = subprocess.Popen(['sleep', '60'], start_new_session=True)\n"
      "  open('pids.part', 'w').write(f'{os.getpid()} {child.pid}')\n"
      "  os.rename('pids.part', 'pids')\n"
      "  time.sleep(60)\n");
  const Answer answer = Shell(
      "mkdir tmp; export TMPDIR=$PWD/tmp\n"
      "\"" SMILE_PROGRAM
      "\" run pair.xml --brain brain/think.py --timeout 60 & simulator=$!\n"
      "for k in $(seq 600); do [ -e pids ] && break; sleep 0.05; done\n"
      "pids=$(cat pids) && kill -0 $pids && ls tmp | grep -q smile-brain || exit 8\n"
      "kill -KILL $simulator\n"
      "for k in $(seq 600); do\n"
      "  [ -z \"$(ls tmp)$(ps -o pid= -p ${pids// /,})\" ] && exit 0; sleep 0.05\n"
      "done; exit 9");
  EXPECT_EQ(answer.exit_code, 0) << answer.out << answer.err;
}

TEST_F(BrainTrouble, APythonBrainStopsAtABreakPointAndTheSimulationWaits) {
  WriteStep("  aux.exit = sensor.simTime > 0.05\n");
  const Answer answer = Attached("brain/think.py", "b " + (directory_ / "brain/think.py").string() +
                                                       ":5\nc\nc\np 'time is', sensor.simTime\n"
                                                       "motor.headVelocity = 0.5\n"
                                                       "cl 1\nc\nq\n");
  EXPECT_EQ(answer.exit_code, 0) << Read("stderr.txt") << Read("debugger.txt");
  EXPECT_EQ(Json::parse(Read("result.json"))["brain"]["status"], "exited");
  EXPECT_NE(Read("debugger.txt").find("('time is', 0.0166"), std::string::npos)
      << Read("debugger.txt");
  EXPECT_NE(Read("demo/commands.jsonl").find("\"head\":0.5"), std::string::npos);
}

TEST_F(BrainTrouble, AnOctaveBrainStopsAtABreakPointAndTheSimulationWaits) {
  Write("brain/agentBehavior.m",
        "function [init, callback] = agentBehavior()\ninit = @begin;\ncallback = @act;\n");
  Write("brain/begin.m", "k = 0;\n");
  Write("brain/act.m", "k = k + 1;\nmotor.headVelocity = 0.25 * k;\n");
  const Answer answer = Attached("brain",
                                 "dbstop in act at 2\nsmile_brain\n"
                                 "printf('time is %d\\n', sensor.simTime)\nk = 2;\n"
                                 "dbclear all\ndbcont\nexit\n");
  EXPECT_EQ(answer.exit_code, 0) << Read("stderr.txt") << Read("debugger.txt");
  EXPECT_NE(Read("debugger.txt").find("time is 0"), std::string::npos) << Read("debugger.txt");
  EXPECT_NE(Read("demo/commands.jsonl").find("\"head\":0.5"), std::string::npos);
}

TEST_F(BrainTrouble, TheFaceThatTheRobotEndsWithIsInTheRecording) {
  WriteStep("  aux.exit = sensor.simTime > 0.2\n");
  const auto ticks_after = [this](const std::string& mood) {
    const Answer replay = Smile("replay demo --verify --json");
    EXPECT_EQ(replay.exit_code, 0) << replay.err;
    const std::string log = Read("demo/commands.jsonl");
    const std::size_t line = log.rfind('\n', log.find("\"" + mood + "\"")) + 1;
    const Json face = Json::parse(log.substr(line, log.find('\n', line) - line));
    return replay.json()["ticks"].get<int>() - face["tick"].get<int>();
  };
  ASSERT_EQ(Smile("run pair.xml --brain brain/think.py --record demo --no-pictures").exit_code, 0);
  EXPECT_EQ(ticks_after("done"), 15);
  ASSERT_EQ(Shell("rm -r demo; smile run pair.xml --brain brain/think.py --record demo "
                  "--no-pictures --seconds 0.25")
                .exit_code,
            0);
  EXPECT_EQ(ticks_after("done"), 2) << "the time is what was said";
}

TEST_F(BrainTrouble, AnAttachedProgramThatIsNoBrainIsRejected) {
  WriteStep("");
  Write("noise.py",
        "import os, socket, sys, time\n"
        "s = socket.socket(socket.AF_UNIX)\n"
        "s.connect(os.environ['SMILE_BRAIN_ADDRESS'])\n"
        "if sys.argv[1:]: s.sendall(sys.argv[1].encode())\n"
        "else:\n"
        "  open('quiet', 'w')\n"
        "  time.sleep(30)\n"
        "s.close()\n");
  // One hangs up, one talks of something else, one says nothing and stays.
  const Answer answer =
      Attached("brain/think.py", "c\nq\n",
               "export SMILE_BRAIN_ADDRESS=$(echo \"$line\" | grep -o '[^=]*/socket')\n"
               "python3 noise.py SMB\n"
               "python3 noise.py 'GET / HTTP/1.1, and so on for some more words'\n"
               "python3 noise.py &\n"
               "for k in $(seq 600); do [ -e quiet ] && break; sleep 0.05; done\n");
  EXPECT_EQ(answer.exit_code, 0) << Read("stderr.txt") << Read("debugger.txt");
  EXPECT_EQ(Json::parse(Read("result.json"))["ticks"], 6);
  const std::string messages = Read("stderr.txt");
  for (const char* why : {"closed its connection", "sent an invalid message", "it sent nothing"}) {
    EXPECT_NE(messages.find(why), std::string::npos) << messages;
  }
}

TEST_F(BrainTrouble, ABrainThatCannotBeRunIsWrongInput) {
  Write("robot", "#!/nowhere/python3\n");
  EXPECT_EQ(Smile("run pair.xml --brain robot").exit_code, 1) << "it may not be executed";
  const Answer answer = Shell("chmod +x robot; smile run pair.xml --brain robot");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("robot: the brain cannot be run: "), std::string::npos) << answer.err;
}

TEST_F(BrainTrouble, AnAttachedBrainThatHangsUpIsNoticed) {
  WriteStep("  os._exit(1)\n");
  const Answer answer = Attached("brain/think.py", "c\n");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(Read("stderr.txt").find("closed its connection during the callback"), std::string::npos)
      << Read("stderr.txt") << Read("debugger.txt");
}

}  // namespace
}  // namespace smile
