// Brains that break every rule: each ends soon, with a clear message, and leaves nothing.

#include <signal.h>

#include <cerrno>
#include <vector>

#include "brain_fixture.h"

namespace smile::brain {
namespace {

constexpr double kSecondsAtMost = 30;  ///< for an end that a busy machine delays; none lasts 60
const std::string kTooLong = "took longer than 0.5 s and was stopped";

struct Hostile {
  const char* name;
  std::string text;     ///< of the program
  std::string message;  ///< that the error has in it
};

void PrintTo(const Hostile& hostile, std::ostream* out) { *out << hostile.name; }

/// In Python, with our client: what its step does.
Hostile Step(const char* name, const std::string& line, const std::string& message) {
  return {name,
          "import ctypes, os, signal, subprocess, sys, threading, time\nimport numpy as np\n"
          "def step(sensor, motor, aux):\n  " +
              line + "\n",
          message};
}

/// Without our client: what it does with the connection, after greeting and init when `has_begun`.
Hostile Raw(const char* name, const std::string& lines, const std::string& message,
            bool has_begun = true) {
  std::string text = R"(#!/usr/bin/python3
import os, signal, socket, struct, sys, time
def connect():
  s = socket.socket(socket.AF_UNIX); s.connect(os.environ['SMILE_BRAIN_ADDRESS']); return s
def pad(b): return b + bytes(-len(b) % 8)
def array(name, rows, cols, value=0.0):
  return pad(struct.pack('<4B2I', len(name), 0, 2, 0, rows, cols) + name) + struct.pack('<d', value) * (rows * cols)
def frame(kind, sequence, *arrays):
  body = struct.pack('<2I', len(arrays), 0) + b''.join(arrays)
  return struct.pack('<4I', 0x31424d53, kind, sequence, len(body)) + body
def hello(): return frame(1, 0, array(b'version', 1, 1, 1))
def motor(sequence): return frame(5, sequence, array(b'jointVelocities', 2, 7), array(b'gripperVelocities', 2, 1))
def read(s):
  header = struct.unpack('<4I', s.recv(16, socket.MSG_WAITALL))
  s.recv(header[3], socket.MSG_WAITALL); return header[2]
def begin(s):
  s.sendall(hello()); s.sendall(frame(3, read(s))); return read(s)
s = connect()
)";
  if (has_begun) text += "q = begin(s)\n";
  return {name, text + lines + "\ntime.sleep(60)\n", message};
}

const std::vector<Hostile>& AllHostile() {
  static const std::vector<Hostile> all{
      Step("StopsItself", "os.kill(os.getpid(), signal.SIGSTOP)", kTooLong),
      Step("Crashes", "ctypes.string_at(0)", "it was ended by signal 11 (Segmentation fault)"),
      Step("Aborts", "os.abort()", "it was ended by signal 6 (Aborted)"),
      Step("Loops", "while True: pass", ".py:4: the callback " + kTooLong),
      Step("ComputesForMinutes", "np.linalg.svd(np.ones((2500, 2500)))", kTooLong),
      Step("Sleeps", "time.sleep(60)", ".py:4: the callback " + kTooLong),
      Step("WaitsForAChild", "os.system('sleep 60')", kTooLong),
      Step("IgnoresSignals",
           "[signal.signal(n, signal.SIG_IGN) for n in (2, 10, 12, 15)]; time.sleep(60)", kTooLong),
      Step("WrongShape", "motor.jointVelocities = np.zeros((7, 2))", "is 7x2, expected 2x7"),
      Step("NotANumber", "motor.jointVelocities[1, 2] = np.nan", "[1, 2] is nan"),
      Step("Infinite", "motor.jointVelocities[:] = np.inf", "[0, 0] is inf"),
      Step("Huge", "motor.jointVelocities = np.zeros((3000, 3000))", "is 3000x3000, expected 2x7"),
      Step("ExitsQuietly", "os._exit(0)", "it ended with exit code 0"),
      Step("Exits", "sys.exit(3)", ".py:4: the program called exit(3)"),
      Step("Recurses", "step(sensor, motor, aux)", ".py:4: RecursionError: maximum recursion"),
      Step("WritesIntoTheConnection",
           "[os.write(n, b'x' * 100) for n in range(3, 20) if os.path.exists(f'/proc/self/fd/{n}') "
           "and 'socket' in os.readlink(f'/proc/self/fd/{n}')]",
           "the received bytes are not a message"),
      Step("StopsItsSupervisor", "os.kill(os.getppid(), signal.SIGSTOP); time.sleep(60)", kTooLong),
      Step("KillsItsSupervisor", "os.kill(os.getppid(), signal.SIGKILL); time.sleep(60)",
           "it was ended by signal 9 (Killed)"),
      Step("LeavesAChild", "os.fork() or time.sleep(60); os._exit(0)", "it ended with exit code 0"),
      Raw("ExitsInInit", "s.sendall(hello()); read(s); sys.exit(0)",
          "the brain ended during init: it ended with exit code 0", false),
      Raw("StaysSilent", "", "the start took longer than 3 s", false),
      Raw("SpeaksOnItsSecondConnection", "t = connect(); t.sendall(hello())",
          "the start took longer than 3 s", false),
      Raw("RandomBytes", "s.sendall(os.urandom(100000))", "the received bytes are not a message",
          false),
      Raw("RandomBytesInAFrame",
          "s.sendall(struct.pack('<4I', 0x31424d53, 5, q, 4096) + b'\\xff' * 4096)",
          "the brain sent an invalid message during the callback"),
      Raw("HalfAFrame", "s.sendall(motor(q)[:77])", "the callback " + kTooLong),
      Raw("HalfAHeader", "s.sendall(motor(q)[:7])", "the callback " + kTooLong),
      Raw("ByteByByte", "for b in motor(q): s.sendall(bytes([b])); time.sleep(0.05)",
          "the callback " + kTooLong),
      Raw("AnnouncesTooMuch", "s.sendall(struct.pack('<4I', 0x31424d53, 5, q, 0xffffffff))",
          "a message of 4294967295 bytes, expected at most 67108864"),
      Raw("SendsTooMuch", "s.sendall(frame(5, q, array(b'jointVelocities', 2000, 2000)))",
          "motor.jointVelocities is 2000x2000, expected 2x7"),
      Raw("AnswersAnotherQuestion", "s.sendall(motor(q + 1))", "not an answer to the request"),
      Raw("AnswersTwice", "s.sendall(motor(q) + motor(q)); read(s)",
          "not an answer to the request"),
      Raw("AnswersSomethingElse", "s.sendall(hello())", "not an answer to the request"),
      Raw("HangsUp", "s.close()", "the brain closed its connection during the callback"),
      Raw("DoesNotRead", "time.sleep(60)", "the callback " + kTooLong),
      {"HasNoInterpreter", "#!/nowhere/python3\n",
       "the brain cannot be run: its interpreter does not exist, expected"},
      {"IsNoProgram", "#!\n", "the brain cannot be run: it is not a program, expected"},
      Raw("ErrorWithoutWords", "s.sendall(frame(7, q))", "an error without a message"),
  };
  return all;
}

class HostileBrains : public BrainProcessTest, public testing::WithParamInterface<Hostile> {
 protected:
  /// What became of two steps of it, each with a picture, so that pipes fill up.
  std::string ErrorOf(const Hostile& hostile) {
    const bool is_raw = hostile.text.starts_with("#!");
    // Who is not late has all the time that a busy machine may take.
    const auto is_late = [&](const char* what) {
      return hostile.message.find(what) != std::string::npos;
    };
    BrainProcess brain(Program(is_raw ? "hostile" : "hostile.py", hostile.text),
                       {.start_seconds = is_late("the start took longer") ? 3.0 : 20.0,
                        .callback_seconds = is_late("took longer") ? 0.5 : 20.0});
    const auto begun = brain.Init(Classic(Aux()));
    if (std::holds_alternative<BrainError>(begun)) return ErrorIn(begun);
    const Sensor sensor = Classic(Sensor{.pictures = {{.image = Gradient(640, 480)}}});
    auto reply = brain.Step(sensor);
    if (std::holds_alternative<StepReply>(reply)) reply = brain.Step(sensor);
    EXPECT_FALSE(brain.is_running());
    return ErrorIn(reply);
  }
};

TEST_P(HostileBrains, EndSoonWithAnExplanation) {
  std::string error;
  EXPECT_LT(SecondsOf([&] { error = ErrorOf(GetParam()); }), kSecondsAtMost);
  EXPECT_TRUE(error.starts_with("brain/hostile")) << error;
  EXPECT_NE(error.find(GetParam().message), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(All, HostileBrains, testing::ValuesIn(AllHostile()),
                         [](const auto& brain) { return std::string(brain.param.name); });

class BrainLeftovers : public BrainProcessTest {};

bool IsAlive(const std::string& pid) { return ::kill(std::stoi(pid), 0) == 0 || errno != ESRCH; }

TEST_F(BrainLeftovers, NoChildProcessSurvives) {
  BrainProcess brain(Program("parent.py",
                             "import subprocess\n"
                             "def step(sensor, motor, aux):\n"
                             "  child = subprocess.Popen(['sleep', '60'], start_new_session=True)\n"
                             "  open(aux.path + 'pid', 'w').write(str(child.pid))\n"));
  Started(brain);
  Stepped(brain);
  const std::string pid = ReadFile(root_ / "brain/pid", 100);
  EXPECT_TRUE(IsAlive(pid));
  brain.Stop();
  EXPECT_FALSE(IsAlive(pid));
}

TEST_F(BrainLeftovers, AFloodOfOutputDoesNoHarm) {
  BrainProcess brain(Program("chatty.py",
                             "import sys\n"
                             "def step(sensor, motor, aux):\n"
                             "  for k in range(100): sys.stdout.buffer.write(b'x' * 1000000)\n"));
  Started(brain);
  Stepped(brain);
  EXPECT_TRUE(brain.is_running());
}

TEST_F(BrainLeftovers, FoldersOfKilledSimulatorsAreRemoved) {
  const fs::path stale = root_ / "tmp/smile-brain-stale", fresh = root_ / "tmp/smile-brain-fresh";
  for (const fs::path& folder : {stale, fresh}) {
    MakeDirectories(folder);
    WriteFile(folder / "left", "");
  }
  fs::last_write_time(stale, fs::file_time_type::clock::now() - std::chrono::hours(1));
  BrainProcess brain(Program("calm.py", "def step(*_): pass\n"));
  Started(brain);
  EXPECT_FALSE(fs::exists(stale));
  EXPECT_TRUE(fs::exists(fresh)) << "another process may be about to lock it";
  fs::remove_all(fresh);
}

}  // namespace
}  // namespace smile::brain
