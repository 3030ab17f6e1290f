// Runs with brains, which are given pictures.

#include "base/diagnostic.h"
#include "experiment/imitation.h"
#include "experiment_fixture.h"
#include "recording/notes.h"
#include "recording/recording.h"
#include "recording/time_range.h"
#include "replay/replay.h"

namespace smile::experiment {
namespace {

class RunBrain : public ExperimentTest {
 protected:
  /// Small pictures, which software draws quickly.
  RunPlan PlanWith(const fs::path& brain) const {
    return {.scene = Pair(),
            .robot = Baxter(),
            .brain = brain,
            .record = root_ / "run",
            .has_pictures = false,
            .eye = {.width_px = 32, .height_px = 24}};
  }
};

TEST_F(RunBrain, TheExampleInCppMovesTheRobot) {
  RunPlan plan = PlanWith(SMILE_CPP_BRAIN);
  plan.seconds = 0.5;
  const RunResult result = experiment::Run(plan);
  EXPECT_EQ(result.ticks, 30u);
  EXPECT_EQ(result.brain_status, brain::BrainStatus::kRunning);
  EXPECT_EQ(BrainJson(result)["status"], "running");
  const Json& arms = result.robot;
  EXPECT_NEAR(arms["left"]["joints"][0].get<double>(), -arms["right"]["joints"][0].get<double>(),
              0.05);
  EXPECT_GT(std::abs(arms["left"]["joints"][0].get<double>()), 0.05);
  EXPECT_NE(Read("run/notes.jsonl").find("waves with both arms"), std::string::npos);
}

TEST_F(RunBrain, AFailureIsReportedAndTheRecordingKept) {
  const RunResult result =
      experiment::Run(PlanWith(Python("  if sensor.simTime > 0.2: raise ValueError('no idea')\n")));
  EXPECT_EQ(result.brain_status, brain::BrainStatus::kFailed);
  ASSERT_TRUE(result.brain_error);
  EXPECT_NE(result.brain_error->message.find("no idea"), std::string::npos);
  EXPECT_EQ(result.recordings, std::vector<fs::path>{root_ / "run"});
  EXPECT_GE(TicksOf(recording::OpenRecording(root_ / "run")).last, 12u);
  EXPECT_NE(Read("run/brain.log").find("no idea"), std::string::npos);
}

TEST_F(RunBrain, ABrainThatEndsEndsTheRun) {
  const RunResult result = experiment::Run(PlanWith(Python("  aux.exit = sensor.simTime > 0.2\n")));
  EXPECT_EQ(result.brain_status, brain::BrainStatus::kExited);
  EXPECT_FALSE(result.brain_error);
  EXPECT_LT(result.seconds, 0.7);
}

TEST_F(RunBrain, NotesAreRecordedOnceWithTheirTick) {
  (void)experiment::Run(
      PlanWith(Write("brain/notes.py",
                     "def init(aux): aux.cameras = ['left_hand']\n"
                     "def step(sensor, motor, aux):\n"
                     "  if 'said' not in aux:\n"
                     "    aux.said, aux.notes = True, ['saw: a block', 'plan: to leave it']\n"
                     "    aux.noteTops = [[1, 1, 0, 2, 1, 4, 1, 0.5, 0]]\n"
                     "    aux.noteCameras = ['left_hand']\n"
                     "  if sensor.simTime > 0.2: aux.exit, aux.notes = True, 'action: ends'\n")));
  const auto notes = recording::NotesOf(recording::OpenRecording(root_ / "run"));
  const sim::NotedTop top{.middle = Vector3(0, 2, 1), .length = 4, .width = 1, .yaw = 0.5};
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_EQ(notes[0].note,
            (sim::Note{.word = "saw", .text = "a block", .found = {top}, .camera = "left_hand"}));
  EXPECT_EQ(notes[1].note, (sim::Note{.word = "plan", .text = "to leave it"}));
  EXPECT_EQ(notes[2].note.text, "ends");
  EXPECT_EQ(notes[0].tick, 0u);
  EXPECT_GE(notes[2].tick, 12u);
}

TEST_F(RunBrain, IsToldTheVariationAndTruePosesOnRequest) {
  RunPlan plan =
      PlanWith(Write("brain/told.py",
                     "def init(aux):\n"
                     "  print(aux.variationSpeed, aux.variationOrder)\n"
                     "  print(aux.objectNames, aux.objectSizes[1], aux.objectColors[1])\n"
                     "def step(sensor, motor, aux):\n"
                     "  print(sensor.objectPoses.shape, sensor.objectPoses[:3, 3, 1])\n"
                     "  aux.exit = True\n"));
  plan.behavior = {.speed = 0.5, .order = 7};
  plan.gives_poses = true;
  const RunResult result = experiment::Run(plan);
  EXPECT_FALSE(result.brain_error) << ToString(*result.brain_error);
  const std::string log = Read("run/brain.log");
  EXPECT_NE(log.find("0.5 7"), std::string::npos) << log;
  EXPECT_NE(log.find("(4, 4, 2) [ 2.  -3.   0.5]"), std::string::npos) << log;
  EXPECT_NE(log.find("[1. 1. 1.] [0. 0. 1.]"), std::string::npos) << log;
}

TEST_F(RunBrain, ADisturbanceReplaysAsItWas) {
  RunPlan plan = PlanWith(Python("  aux.exit = sensor.simTime > 2\n"));
  plan.disturbance = {.seconds = 0.5, .choice = 0.6, .direction_deg = 30, .distance = 0.4};
  const RunResult result = experiment::Run(plan);
  EXPECT_EQ(result.disturbance["object"], "b");
  EXPECT_EQ(replay::Replay(recording::OpenRecording(root_ / "run")).first_difference, std::nullopt);
  plan.record = root_ / "again";
  EXPECT_EQ(experiment::Run(plan).state_hash, result.state_hash);
}

TEST_F(RunBrain, AMissingOneLeavesNoRecording) {
  EXPECT_THROW(experiment::Run(PlanWith(root_ / "nowhere")), InputError);
  EXPECT_FALSE(Exists("run"));
}

TEST_F(RunBrain, StartMayTakeTwelveTimesAsLongAsACallback) {
  EXPECT_EQ(brain::BrainOptions().start_seconds, 60);  // docs/brain-protocol.md
  EXPECT_EQ(RunPlan().callback_seconds, 5);
  EXPECT_EQ(brain::WithTimeout(0.5).start_seconds, 6);
  RunPlan plan = PlanWith(
      Write("slow/slow.py", "import time\ntime.sleep(60)\ndef step(sensor, motor, aux): pass\n"));
  plan.callback_seconds = 0.05;
  const RunResult result = experiment::Run(plan);
  ASSERT_TRUE(result.brain_error);
  EXPECT_NE(result.brain_error->message.find("0.6 s"), std::string::npos)
      << result.brain_error->message;
}

TEST_F(RunBrain, WatchingNeedsADemonstration) {
  const RunResult result = experiment::Run(
      PlanWith(Write("brain/watcher.py",
                     "def init(aux): aux.watch = True\ndef step(sensor, motor, aux): pass\n")));
  EXPECT_EQ(ToString(result.brain_error.value()),
            "brain/watcher.py: aux.watch is true, but no demonstration is given");
  EXPECT_EQ(result.ticks, 0u);
}

class ImitationTest : public ExperimentTest {
 protected:
  ImitationPlan PlanWith(const fs::path& brain) const {
    return {.task = "stack",
            .demonstration = RecordStacking(),
            .scene = Pair(),
            .brain = brain,
            .record = root_ / "imitation",
            .has_pictures = false,
            .eye = {.width_px = 32, .height_px = 24},
            .robot = Baxter()};
  }
};

TEST_F(ImitationTest, IsScoredAgainstTheDemonstration) {
  const ImitationResult result = Imitate(PlanWith(Python("  aux.exit = True\n")));
  EXPECT_FALSE(result.has_succeeded);
  EXPECT_FALSE(result.brain_error);
  EXPECT_EQ(result.json["task"], "stack");
  EXPECT_EQ(result.json["brain"]["status"], "exited");
  EXPECT_LT(result.json["score"].get<double>(), 1);
  EXPECT_TRUE(recording::IsRecording(root_ / "imitation"));
}

TEST_F(ImitationTest, ACancelledOneIsScoredAsFarAsItCame) {
  const ImitationPlan plan = PlanWith(Python("  pass\n"));
  bool has_begun = false;
  const ImitationResult result = Imitate(
      plan,
      {.is_cancelled = [&] { return has_begun; },
       .on_progress = [&](const std::string&, double done, double) { has_begun = done > 0.3; }});
  EXPECT_FALSE(result.has_succeeded);
  EXPECT_NEAR(result.json["seconds"].get<double>(), 0.3, 0.05);
  EXPECT_TRUE(recording::IsRecording(root_ / "imitation"));
}

TEST_F(ImitationTest, AProgramThatRequestsItWatchesTheDemonstrationBeforeItActs) {
  ImitationPlan plan = PlanWith(Write("brain/watcher.py",
                                      "def init(aux): aux.watch, aux.frames = True, []\n"
                                      "def step(sensor, motor, aux):\n"
                                      "  motor.jointVelocities[:] = 0.1\n"
                                      "  if sensor.demoCue:\n"
                                      "    assert (sensor.jointVelocities == 0).all()\n"
                                      "    aux.frames.append(sensor.rgbVision.tobytes())\n"
                                      "  elif sensor.jointVelocities.any():\n"
                                      "    print(len(aux.frames), len(set(aux.frames)) > 2)\n"));
  // What it may take counts from the end of watching, which is longer.
  plan.max_seconds = 0.5;
  const recording::Recording demonstration = recording::OpenRecording(plan.demonstration);
  const double length = recording::SecondsInto(demonstration, TicksOf(demonstration).last);
  ASSERT_GT(length, 0.5);
  const ImitationResult result = Imitate(plan);
  EXPECT_FALSE(result.brain_error) << ToString(*result.brain_error);
  EXPECT_NEAR(result.json["seconds"].get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(result.json["watched_seconds"].get<double>(), length, 0.25);
  const int num_frames = CountLines("stacked/frames.csv") - 1;
  EXPECT_TRUE(Read("imitation/brain.log").starts_with(std::to_string(num_frames) + " True\n"))
      << Read("imitation/brain.log");
  // The robot stood still meanwhile, and a replay needs no demonstration.
  const recording::Recording imitation = recording::OpenRecording(root_ / "imitation");
  EXPECT_EQ(replay::Replay(imitation).first_difference, std::nullopt);
  EXPECT_NEAR(recording::SecondsInto(imitation, TicksOf(imitation).last),
              result.json["watched_seconds"].get<double>() + 0.5, 1e-9);
}

TEST_F(ImitationTest, ASceneWithoutTheObjectsIsRefused) {
  ImitationPlan plan = PlanWith(Python("  pass\n"));
  plan.scene = SceneOf("<block id=\"b\" color=\"blue\" location=\"(2, -3, 0.5)\"/>");
  EXPECT_THROW(Imitate(plan), InputError);
  EXPECT_FALSE(Exists("imitation"));
}

}  // namespace
}  // namespace smile::experiment
