// Recordings are not trusted: damaged files are read or refused.

#include <fstream>
#include <random>

#include "base/diagnostic.h"
#include "recorder/recording_controller.h"
#include "recording/attention.h"
#include "recording/demonstration.h"
#include "recording/recording_history.h"
#include "recording/trace_reader.h"
#include "recording_fixture.h"
#include "replay/replay.h"
#include "scene_xml/scene_writer.h"
#include "sim/test/everything_scene.h"
#include "sim/test/random_hands.h"

namespace smile::recorder {
namespace {

class DamageProperty : public RecordingFixture, public ::testing::WithParamInterface<const char*> {
 protected:
  /// A recording that began late, of one of each mechanism, with undos.
  std::filesystem::path RecordEverything() {
    const std::string xml = scene_xml::WriteScene(sim::EverythingScene::Make());
    sim::Simulation simulation(*scene_xml::ReadSceneText(xml, "everything.xml").scene);
    RecordingController controller(&simulation, {.root = root_});
    sim::RandomHands hands(7, /*changes_objects=*/true);
    for (int i = 0; i < 60; ++i) {
      if (i == 10) (void)simulation.Apply(sim::StartRecording{.name = "demo"});
      (void)simulation.Apply(i % 6 == 5 ? sim::Command(sim::Undo()) : hands.Next(simulation));
      simulation.Tick();
    }
    return root_ / "demo";
  }

  /// Reads everything about a recording that needs no simulation.
  static void ReadAll(const std::filesystem::path& demo) {
    const recording::Recording recording = recording::OpenRecording(demo);
    (void)recording::AttentionOf(recording);
    (void)recording::DemonstrationOf(recording);
    for (const recording::Segment& step : recording::HistoryOf(recording)) {
      recording::TraceReader trace(recording, step.end);
      while (trace.Next()) {
      }
      (void)recording::HistoryPointIn(recording, step, (step.end.tick - step.begin.tick) / 2);
    }
  }
};

TEST_P(DamageProperty, IsReadOrRefusedAndNeverCrashes) {
  const auto demo = RecordEverything();
  ReadAll(demo);
  const std::string whole = ReadFile(demo / GetParam(), 1 << 24);
  std::mt19937 random(3);
  int num_refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string damaged = whole;
    if (random() % 4 == 0) damaged.resize(random() % damaged.size());
    for (int k = 0; k < 3 && !damaged.empty(); ++k) {
      char& letter = damaged[random() % damaged.size()];
      // Mostly of the same kind, to pass the first checks.
      letter = std::isdigit(static_cast<unsigned char>(letter)) != 0
                   ? static_cast<char>('0' + random() % 10)
                   : static_cast<char>(random());
    }
    std::ofstream(demo / GetParam(), std::ios::binary) << damaged;
    try {
      ReadAll(demo);
    } catch (const InputError& error) {
      ++num_refused;
      EXPECT_FALSE(error.diagnostics().front().message.empty());
    }
  }
  EXPECT_GT(num_refused, 20);
}

class DamagedRobot : public RecordingFixture {
 protected:
  std::string Complaint() const {
    try {
      (void)recording::OpenRecording(root_ / "demo");
    } catch (const InputError& error) {
      return error.diagnostics().front().message;
    }
    return "";
  }
};

TEST_F(DamagedRobot, IsReadOnlyFromTheRecording) {
  namespace fs = std::filesystem;
  const fs::path robot = Record("", /*with_robot=*/true) / "robot", outside = root_ / "outside";
  ASSERT_EQ(Complaint(), "");
  fs::rename(robot, outside);
  const fs::path before = fs::current_path();
  fs::current_path(outside);  // not a place to look in
  EXPECT_EQ(Complaint(), "no such file");
  fs::current_path(before);
  fs::create_directory_symlink(outside, robot);
  EXPECT_EQ(Complaint(), "is outside the recording, expected inside");
  fs::remove(robot);
  fs::create_directory(robot);
  fs::create_symlink(outside / "baxter.urdf", robot / "baxter.urdf");
  EXPECT_EQ(Complaint(), "no such file");
}

TEST_F(DamagedRobot, IsNotRecordedWithoutItsFiles) {
  const auto scene = MakeSimulation(/*with_robot=*/false)->scene();
  const sim::Simulation simulation(scene, sim::RobotPlacement{.model = {}});
  EXPECT_THROW(Recorder(root_ / "demo", {}, nullptr, simulation), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(root_ / "demo"));
}

INSTANTIATE_TEST_SUITE_P(Files, DamageProperty,
                         ::testing::Values("demo.json", "commands.jsonl", "trace.bin",
                                           "trace.index"));

}  // namespace
}  // namespace smile::recorder
