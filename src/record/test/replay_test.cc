#include "record/replay.h"

#include <cstring>
#include <fstream>
#include <random>

#include "base/diagnostic.h"
#include "recording_fixture.h"

namespace smile::record {
namespace {

class ReplayTest : public RecordingFixture {
 protected:
  static std::string Text(const std::filesystem::path& path) { return ReadFile(path, 1 << 26); }
  static void Overwrite(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
  }
  static std::string Complaint(const std::filesystem::path& directory) {
    try {
      OpenRecording(directory);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ReplayTest, IsIdenticalToTheLastBit) {
  const ReplayReport report = Replay(OpenRecording(Record()));
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_GT(report.ticks, 150u);
  EXPECT_EQ(report.hash, final_hash_);
}

TEST_F(ReplayTest, IsIdenticalWithARobotThatMoves) {
  const ReplayReport report = Replay(OpenRecording(Record(
      R"({"do":"joint_angles","left":[0.1,-0.5,0,0.9,0,1.1,0]}
{"do":"joint_velocities","left":[0.2,0.1,-0.3,0,0,0.1,0.5],"grippers":[-0.7,0.3],"head":0.3}
{"do":"wait","seconds":1}
{"do":"joint_velocities","left":[0,0,0,0,0,0,0],"head":0}
{"do":"wait","seconds":0.5})",
      /*with_robot=*/true)));
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_EQ(report.hash, final_hash_);
}

TEST_F(ReplayTest, NamesTheFirstTickObjectAndQuantityThatDiffers) {
  const auto directory = Record();
  std::string commands = Text(directory / "commands.jsonl");
  const std::string target = "[3.0,-2.0,3.0]";
  ASSERT_NE(commands.find(target), std::string::npos) << commands;
  commands.replace(commands.find(target), target.size(), "[3.0,-2.1,3.0]");
  Overwrite(directory / "commands.jsonl", commands);

  const Recording recording = OpenRecording(directory);
  const ReplayReport report = Replay(recording);
  ASSERT_TRUE(report.first_difference.has_value());
  // Its target goes elsewhere at once (the hash sees that), the block itself a moment later.
  EXPECT_EQ(report.first_difference->tick, recording.commands[2].tick + 1);
  EXPECT_EQ(report.first_difference->object, "a");
  EXPECT_EQ(report.first_difference->quantity, "position");
}

TEST_F(ReplayTest, OpensWhatACrashCutShortAndSaysSo) {
  const auto directory = Record();
  const std::string commands = Text(directory / "commands.jsonl");
  Overwrite(directory / "commands.jsonl", commands.substr(0, commands.size() - 5));
  const std::string trace = Text(directory / "trace.bin");
  Overwrite(directory / "trace.bin", trace.substr(0, trace.size() / 4 + 3));

  const Recording recording = OpenRecording(directory);
  EXPECT_EQ(recording.cuts,
            (std::vector<std::string>{"the last line of commands.jsonl was cut and is left out"}));
  const ReplayReport report = Replay(recording);
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_TRUE(report.is_cut);
  EXPECT_GT(report.ticks, 20u);
}

TEST_F(ReplayTest, NoticesAPoseThatWasChangedInTheTrace) {
  const auto directory = Record();
  std::string trace = Text(directory / "trace.bin");
  // The height of the first object in the first record, after the header, the record's head, the
  // object's index and whether it is there.
  const std::size_t header = 8 + 4 + 4 + 2 * (4 + 1) + 4, head = 8 + 8 + 1 + 4;
  const double lower = 0.04;
  std::memcpy(&trace[header + head + 4 + 1 + 2 * sizeof(double)], &lower, sizeof lower);
  Overwrite(directory / "trace.bin", trace);
  const auto difference = Replay(OpenRecording(directory)).first_difference;
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->object, "a");
  EXPECT_EQ(difference->recorded, "(0, -2, 0.4)");
}

TEST_F(ReplayTest, ATraceThatJumpsAheadIsDamaged) {
  const auto directory = Record();
  ByteWriter jump;
  jump.Put(std::uint64_t{1'000'000'000'000});
  jump.Put(std::uint64_t{0});
  jump.Put(std::uint8_t{0});
  jump.Put(std::uint32_t{0});
  std::ofstream(directory / "trace.bin", std::ios::binary | std::ios::app)
      .write(reinterpret_cast<const char*>(jump.bytes().data()),
             static_cast<std::streamsize>(jump.size()));
  EXPECT_THROW(Replay(OpenRecording(directory)), InputError);
}

TEST_F(ReplayTest, NoticesACommandAfterTheEnd) {
  const auto directory = Record();
  std::ofstream(directory / "commands.jsonl", std::ios::app)
      << "{\"tick\":99999,\"hand\":\"left\",\"do\":\"release\"}\n";
  EXPECT_EQ(Replay(OpenRecording(directory)).first_difference->quantity, "command");
}

TEST_F(ReplayTest, SaysWhatIsWrongWithAFileThatIsNoRecording) {
  EXPECT_EQ(Complaint(root_),
            root_.string() + ": is not a recording; expected a directory with a demo.json in it");
  const auto directory = Record();
  Overwrite(directory / "commands.jsonl", "{\"tick\":3,\"do\":\"fly\"}\n");
  EXPECT_EQ(Complaint(directory).substr(0, Complaint(directory).find(", expected")),
            (directory / "commands.jsonl").string() + ":1: \"do\" is \"fly\"");
}

TEST_F(ReplayTest, NeverCrashesOnDamagedTraces) {
  const auto directory = Record();
  const Recording recording = OpenRecording(directory);
  const std::string trace = Text(directory / "trace.bin");
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    std::string damaged = trace.substr(0, 400 + random() % 4000);
    for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
    Overwrite(directory / "trace.bin", damaged);
    try {
      TraceReader reader(recording);
      while (reader.Next()) {
      }
    } catch (const InputError&) {
    }
  }
}

TEST_F(ReplayTest, NeverOverwritesARecording) {
  const auto directory = Record();
  auto simulation = MakeSimulation(false);
  try {
    Recorder again(directory, {}, nullptr, *simulation);
    FAIL() << "it overwrote a recording";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().front().message,
              "exists already; a recording is never overwritten, name a new directory");
  }
}

TEST_F(ReplayTest, OfASceneWithAMeshNeedsNoOtherFile) {
  const auto original = root_ / "original";
  std::filesystem::create_directories(original);
  std::filesystem::copy(DataFile("scenes/meshes"), original / "meshes");
  std::filesystem::copy(DataFile("scenes/meshes.xml"), original / "meshes.xml");
  {
    sim::Simulation simulation(scene_xml::LoadScene(original / "meshes.xml"));
    Recorder recorder(root_ / "demo", {}, nullptr, simulation);
    simulation.AddListener(&recorder);
    while (simulation.tick() < 120) simulation.Tick();
    final_hash_ = simulation.state_hash();
  }
  std::filesystem::remove_all(original);
  const ReplayReport report = Replay(OpenRecording(root_ / "demo"));
  EXPECT_FALSE(report.first_difference);
  EXPECT_EQ(report.ticks, 120u);
  EXPECT_EQ(report.hash, final_hash_);
}

}  // namespace
}  // namespace smile::record
