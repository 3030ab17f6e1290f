// Brains in a session, which does not wait for those that take their time.

#include "brain/brain_driver.h"
#include "recorder/test/painted_eye.h"
#include "recording/time_range.h"
#include "replay/replay.h"
#include "robot/test/generated_robot.h"
#include "scene_xml/scene_reader.h"
#include "session_fixture.h"
#include "studio/live_brain.h"
#include "task/imitation_result.h"

namespace smile::studio {
namespace {

class SessionBrainTest : public SessionFixture {
 protected:
  void SetUp() override { Begin(nullptr, /*with_robot=*/true); }

  /// A program that has `gate()` to wait at until Open().
  void WriteGated(const std::string& name, const std::string& text) {
    WritePython(name,
                "import os, time\n"
                "import numpy as np\n"
                "def gate():\n"
                "  open('" +
                    (root_ / "waits").string() + "', 'w')\n  while not os.path.exists('" +
                    (root_ / "open").string() + "'): time.sleep(0.005)\n" + text);
  }
  void Open() { WriteFile(root_ / "open", ""); }
  /// Until the program waits there.
  void TickToGate() {
    while (!std::filesystem::remove(root_ / "waits")) {
      if (!session_->Tick()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      Take();
    }
  }
  std::uint64_t TickNow() { return State()["tick"].get<std::uint64_t>(); }
  std::string Status() { return State()["brain"]["status"].get<std::string>(); }
  /// The world stands still, and all else continues.
  void ExpectLiveliness() {
    const std::uint64_t tick = TickNow();
    for (int i = 0; i < 6; ++i) EXPECT_FALSE(session_->Tick());
    EXPECT_EQ(TickNow(), tick);
    Command(R"({"do":"grasp","hand":"left","object":"a"})");
    for (int i = 0; i < 6; ++i) EXPECT_FALSE(session_->Tick());
    EXPECT_EQ(Latest("state")["hands"]["left"]["object"], "a");
    EXPECT_NE(Refused(R"({"do":"command","command":{"do":"undo"}})").find("stop it first"),
              std::string::npos);
    EXPECT_EQ(TickNow(), tick);
  }
};

TEST_F(SessionBrainTest, ABrainRunsAndItsErrorHasAPlace) {
  WritePython("wave.py",
              "def step(sensor, motor, aux):\n"
              "  motor.headVelocity = 0.5\n"
              "  if sensor.simTime > 0.1: print('look at wave.py:2')\n"
              "  if sensor.simTime > 0.3: undefined\n");
  const Json brains = Do(R"({"do":"brains"})")["brains"];
  EXPECT_EQ(brains[0]["name"], "brains/wave.py") << "not the one we ship";
  EXPECT_EQ(brains[0]["imitates"], false);
  EXPECT_NE(Refused(R"({"do":"start_brain","brain":"/bin/sh"})").find("\"brain\" is"),
            std::string::npos);
  Do(R"({"do":"start_brain","brain":"wave.py"})");
  TickSeconds(0.2);
  EXPECT_EQ(State()["brain"]["status"], "running");
  EXPECT_GT(State()["robot"]["head"].get<double>(), 0.01);
  TickSeconds(0.3);
  const Json brain = State()["brain"];
  EXPECT_EQ(brain["status"], "failed");
  EXPECT_EQ(brain["line"], 4);
  EXPECT_TRUE(brain["file"].get<std::string>().ends_with("wave.py"));
  TickSeconds(0.1);
  bool has_place = false;
  for (const Json& message : sent_) {
    if (message["t"] != "console") continue;
    for (const Json& line : message["lines"]) {
      has_place = has_place || (line.value("file", "") == "wave.py" && line["line"] == 2);
    }
  }
  EXPECT_TRUE(has_place);
}

TEST_F(SessionBrainTest, AStoppedBrainLeavesArmsOfAnyRobotAtRest) {
  BeginWith(nullptr, sim::RobotPlacement{.model = robot::ThreeArms().Model()});
  WritePython("turn.py",
              "def step(sensor, motor, aux):\n"
              "  for arm in motor.arms: arm.velocities[0] = 0.5\n");
  Do(R"({"do":"start_brain","brain":"turn.py"})");
  TickSeconds(0.5);
  const Json moved = State()["robot"]["joints"];
  for (const char* joint : {"front_j0", "middle_j0", "rear_j0"}) {
    EXPECT_GT(moved[joint].get<double>(), 0.05) << joint;
  }
  Do(R"({"do":"stop_brain"})");
  TickSeconds(0.2);
  const Json stopped = State()["robot"]["joints"];
  TickSeconds(0.3);
  for (const char* joint : {"front_j0", "middle_j0", "rear_j0"}) {
    EXPECT_NEAR(State()["robot"]["joints"][joint].get<double>(), stopped[joint].get<double>(), 2e-3)
        << joint;
  }
}

TEST_F(SessionBrainTest, AnImitationIsScoredAndRecorded) {
  WritePython("lazy.py",
              "# smile: imitates\n"
              "def step(sensor, motor, aux):\n"
              "  assert aux.demonstration.endswith('take')\n"
              "  if sensor.simTime > 0.2: aux.exit = True\n");
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  const Json begun =
      Do(R"({"do":"imitate","recording":"take","brain":"lazy.py","scene":"pair_elsewhere"})");
  EXPECT_EQ(State()["recording"]["title"], "take, imitated");
  TickSeconds(0.5);
  EXPECT_FALSE(State()["recording"].is_null()) << "what it did must still stand";
  TickSeconds(task::kRestSeconds);
  EXPECT_TRUE(State()["recording"].is_null()) << "it ends with the imitation";
  const auto recording =
      recording::OpenRecording(root_ / "recordings" / begun["recording"].get<std::string>());
  EXPECT_EQ(recording.scene().name, "pair_elsewhere");
  EXPECT_EQ(replay::Replay(recording).first_difference, std::nullopt);
  const Json result = Latest("score")["result"];
  EXPECT_EQ(result["task"], "pair_elsewhere");
  EXPECT_FALSE(result["success"].get<bool>());
  EXPECT_EQ(result["match"]["a"], "a");
  EXPECT_EQ(result["cause"]["word"], "never_taken");
  EXPECT_EQ(result["brain"]["status"], "exited");
}

TEST_F(SessionBrainTest, AProgramThatRequestsItWatchesTheDemonstrationFirst) {
  recorder::PaintedEye eye;
  Begin(&eye, /*with_robot=*/true);
  WritePython("watcher.py",
              "# smile: imitates\n"
              "def init(aux): aux.watch, aux.shown = True, []\n"
              "def step(sensor, motor, aux):\n"
              "  motor.jointVelocities[:] = 0.2\n"
              "  if sensor.demoCue: aux.shown.append(int(sensor.rgbVision[0, 0, 0]))\n"
              "  elif sensor.jointVelocities.any():\n"
              "    print('shown', aux.shown[0], len(aux.shown))\n"
              "    aux.exit = True\n");
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  const recording::Recording demo = recording::OpenRecording(root_ / "recordings/take");
  const double length = recording::SecondsInto(demo, TicksOf(demo).last);
  const Json begun =
      Do(R"({"do":"imitate","recording":"take","brain":"watcher.py","scene":"pair"})");
  TickSeconds(length / 2);
  EXPECT_EQ(Status(), "running");
  EXPECT_EQ(State()["robot"]["mood"], "watching");
  TickSeconds(length / 2 + 0.5 + task::kRestSeconds);
  EXPECT_EQ(Status(), "exited") << ToText(State()["brain"]);
  const Json result = Latest("score")["result"];
  EXPECT_NEAR(result["watched_seconds"].get<double>(), length, 0.25);
  EXPECT_LT(result["seconds"].get<double>(), 0.2);
  const auto imitation =
      recording::OpenRecording(root_ / "recordings" / begun["recording"].get<std::string>());
  EXPECT_EQ(replay::Replay(imitation).first_difference, std::nullopt);
  const int num_frames = 1 + static_cast<int>(4 * length);
  EXPECT_EQ(ReadFile(imitation.directory / "brain.log", 100),
            "shown 1 " + std::to_string(num_frames) + "\n");
}

TEST_F(SessionBrainTest, ReportsAnUnreadableDemonstration) {
  WritePython("watcher.py",
              "def init(aux): aux.watch = True\ndef step(sensor, motor, aux): pass\n");
  Do(R"({"do":"start_brain","brain":"watcher.py"})");
  TickSeconds(0.1);
  EXPECT_EQ(Status(), "failed");
  EXPECT_EQ(State()["brain"]["message"], "aux.watch is true, but no demonstration is given");
  // Without an eye nothing is recorded, and nothing can be drawn.
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  Do(R"({"do":"start_brain","brain":"watcher.py","demonstration":"take"})");
  TickSeconds(0.1);
  EXPECT_EQ(Status(), "failed");
  EXPECT_NE(State()["brain"]["message"].get<std::string>().find("no eye to render them"),
            std::string::npos);
  Do(R"({"do":"load","scene":"pair"})");
  EXPECT_EQ(Status(), "none");
}

TEST_F(SessionBrainTest, ImitationRequiresAProgramThatReadsDemonstrations) {
  WritePython("waves.py", "def step(sensor, motor, aux): aux.exit = True\n");
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  EXPECT_NE(Refused(R"({"do":"imitate","recording":"take","brain":"waves.py","scene":"pair"})")
                .find("\"smile: imitates\""),
            std::string::npos);
  EXPECT_TRUE(State()["recording"].is_null());
  EXPECT_EQ(State()["brain"]["status"], "none");
}

TEST_F(SessionBrainTest, ImitationNeedsASceneWithTheDemonstratedObjects) {
  WritePython("lazy.py", "# smile: imitates\ndef step(sensor, motor, aux): aux.exit = True\n");
  WriteFile(root_ / "scenes/other.xml",
            R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="b" color="blue" location="(3, -2, 0.5)"/>
  <block id="c" color="green" location="(0, -2, 0.5)"/>
</tabletop>)xml");
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  const Json scene = Scene();
  const Vector3 place = PositionOf("a");
  EXPECT_NE(Refused(R"({"do":"imitate","recording":"take","brain":"lazy.py","scene":"other"})")
                .find("'a'"),
            std::string::npos);
  // All is as it was left, and nothing has begun.
  EXPECT_EQ(Scene(), scene);
  EXPECT_EQ(PositionOf("a"), place);
  EXPECT_EQ(Status(), "none");
  EXPECT_TRUE(State()["recording"].is_null());
  const std::filesystem::directory_iterator recordings(root_ / "recordings");
  EXPECT_EQ(std::distance(begin(recordings), end(recordings)), 1);
}

TEST_F(SessionBrainTest, AnImitationThatIsStoppedIsRecordedTillThen) {
  WritePython("long.py", "# smile: imitates\ndef step(sensor, motor, aux): pass\n");
  Command(R"({"do":"start","name":"take"})");
  PutAOnB();
  Command(R"({"do":"finish"})");
  Do(R"({"do":"imitate","recording":"take","brain":"long.py","scene":"pair"})");
  TickSeconds(0.2);
  Do(R"({"do":"stop_brain"})");
  EXPECT_TRUE(State()["recording"].is_null());
  EXPECT_TRUE(std::filesystem::exists(root_ / "recordings/take, imitated/demo.json") ||
              std::filesystem::exists(root_ / "recordings/take_ imitated/demo.json"));
}

TEST_F(SessionBrainTest, OnlyTheWorldWaitsWhileAProgramStarts) {
  WriteGated("slow.py",
             "def init(aux):\n  gate()\n"
             "  aux.initJointAngles = np.full((2, 7), 0.25)\n"
             "def step(sensor, motor, aux):\n"
             "  assert (sensor.jointAngles == 0.25).all(), sensor.jointAngles\n"
             "  aux.exit = True\n");
  Do(R"({"do":"start_brain","brain":"slow.py"})");
  TickToGate();
  EXPECT_EQ(Status(), "starting");
  ExpectLiveliness();
  // It also starts while time stands still.
  Do(R"({"do":"pause"})");
  Open();
  while (Status() == "starting") EXPECT_TRUE(session_->Tick());
  EXPECT_EQ(Status(), "running");
  EXPECT_EQ(TickNow(), 0u);
  Do(R"({"do":"resume"})");
  TickSeconds(0.1);
  EXPECT_EQ(Status(), "exited") << ToText(State()["brain"]);
}

TEST_F(SessionBrainTest, OnlyTheWorldWaitsWhileAProgramComputes) {
  WriteGated("slow.py",
             "def step(sensor, motor, aux):\n"
             "  motor.headVelocity = 0.5\n"
             "  if sensor.simTime > 0.1: gate()\n"
             "  if sensor.simTime > 0.3: aux.exit = True\n");
  Command(R"({"do":"start","name":"take"})");
  Do(R"({"do":"start_brain","brain":"slow.py"})");
  TickToGate();
  EXPECT_EQ(Status(), "running");
  ExpectLiveliness();
  Open();
  TickSeconds(0.4);
  EXPECT_EQ(Status(), "exited") << ToText(State()["brain"]);
  Command(R"({"do":"finish"})");
  EXPECT_EQ(replay::Replay(recording::OpenRecording(root_ / "recordings/take")).first_difference,
            std::nullopt);
}

TEST_F(SessionBrainTest, AProgramThatNeverAnswersIsLeftAtAnyTime) {
  WriteGated("sleepy.py", "def init(aux): gate()\ndef step(sensor, motor, aux): pass\n");
  WriteGated("dreamy.py", "def step(sensor, motor, aux): gate()\n");
  WriteGated("brisk.py", "def step(sensor, motor, aux): aux.exit = True\n");
  const auto begin = [this](const std::string& brain) {
    Do(R"({"do":"start_brain","brain":")" + brain + "\"}");
    TickToGate();
  };
  for (const char* brain : {"sleepy.py", "dreamy.py"}) {
    begin(brain);
    Do(R"({"do":"stop_brain"})");
    EXPECT_EQ(Status(), "stopped");
    EXPECT_TRUE(session_->Tick());
    begin(brain);
    Do(R"({"do":"load","scene":"pair_elsewhere"})");
    EXPECT_EQ(Status(), "none");
    EXPECT_TRUE(session_->Tick());
  }
  Do(R"({"do":"start_brain","brain":"brisk.py"})");
  TickSeconds(0.1);
  EXPECT_EQ(Status(), "exited");
  begin("sleepy.py");
  session_.reset();
}

TEST_F(SessionBrainTest, ReportsFailuresAtTheStart) {
  WritePython("hasty.py", "def init(aux):\n  undefined\ndef step(sensor, motor, aux): pass\n");
  Do(R"({"do":"start_brain","brain":"hasty.py"})");
  TickSeconds(0.1);
  const Json brain = State()["brain"];
  EXPECT_EQ(brain["status"], "failed");
  EXPECT_NE(brain["message"].get<std::string>().find("undefined"), std::string::npos);
  EXPECT_EQ(brain["line"], 2);
  bool is_reported = false;
  for (const Json& message : sent_) {
    if (message["t"] != "console") continue;
    for (const Json& line : message["lines"])
      is_reported = is_reported || line.value("line", 0) == 2;
  }
  EXPECT_TRUE(is_reported);
}

TEST(LiveBrain, GivesProgramsTheDocumentedTime) {
  EXPECT_EQ(LiveBrain().limits().start_seconds, 60);  // docs/brain-protocol.md
  EXPECT_EQ(LiveBrain().limits().callback_seconds, 5);
}

TEST_F(SessionBrainTest, ARunWithoutWaitingIsTheSameRun) {
  WritePython("dance.py",
              "import time\n"
              "import numpy as np\n"
              "def init(aux):\n"
              "  aux.initJointAngles = 0.1 * np.arange(14).reshape(2, 7)\n"
              "  aux.drawMarkers = [[0, 0, 1]]\n"
              "def step(sensor, motor, aux):\n"
              "  tick = round(60 * sensor.simTime)\n"
              "  if tick % 9 == 4: time.sleep(0.02)\n"
              "  motor.jointVelocities = 0.4 * np.cos(5 * sensor.jointAngles + tick)\n"
              "  motor.gripperVelocities[:] = sensor.endEffPos[:, 2] / 10\n"
              "  if tick == 30: aux.exit = True\n");
  Command(R"({"do":"start","name":"take"})");
  Do(R"({"do":"start_brain","brain":"dance.py"})");
  TickSeconds(0.6);
  EXPECT_EQ(Status(), "exited") << ToText(State()["brain"]);
  Command(R"({"do":"finish"})");
  const recording::Recording kept = recording::OpenRecording(root_ / "recordings/take");

  sim::Simulation simulation(scene_xml::LoadScene(root_ / "scenes/pair.xml", {}), Baxter());
  const std::filesystem::path program = root_ / "brains/dance.py";
  brain::BrainProcess process(program);
  brain::BrainDriver driver({.may_read = brain::WhatMayBeRead(program)});
  driver.Drive(&process, &simulation);
  while (driver.Drive(&process, &simulation) == brain::BrainStatus::kRunning) simulation.Tick();
  while (simulation.tick() < 36) simulation.Tick();
  const replay::ReplayReport replay = replay::Replay(kept);
  EXPECT_EQ(replay.first_difference, std::nullopt);
  EXPECT_EQ(replay.ticks(), 36u);
  EXPECT_EQ(replay.hash, simulation.state_hash());
}

}  // namespace
}  // namespace smile::studio
