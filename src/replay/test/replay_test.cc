#include "replay/replay.h"

#include <cmath>
#include <cstring>
#include <fstream>

#include "base/bytes.h"
#include "base/diagnostic.h"
#include "recorder/test/recording_fixture.h"
#include "recording/trace_reader.h"

namespace smile::replay {
namespace {

class ReplayTest : public recorder::RecordingFixture {
 protected:
  static std::string Text(const std::filesystem::path& path) { return ReadFile(path, 1 << 26); }
  static void Overwrite(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
  }
  static std::string Complaint(const std::filesystem::path& directory) {
    try {
      recording::OpenRecording(directory);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  /// A recording with altered commands.
  recording::Recording RecordAndReword(const std::string& words, const std::string& others) {
    const auto directory = Record();
    std::string commands = Text(directory / "commands.jsonl");
    const std::size_t place = commands.find(words);
    EXPECT_NE(place, std::string::npos) << commands;
    commands.replace(place, words.size(), others);
    Overwrite(directory / "commands.jsonl", commands);
    return recording::OpenRecording(directory);
  }
  static std::string ComplaintAbout(const recording::TimeRange& range,
                                    const recording::Recording& recording) {
    try {
      recording::TicksOf(range, recording);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ReplayTest, IsIdenticalToTheLastBit) {
  const ReplayReport report = Replay(recording::OpenRecording(Record()));
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_GT(report.ticks(), 150u);
  EXPECT_EQ(report.hash, final_hash_);
}

TEST_F(ReplayTest, IsIdenticalWithARobotThatMoves) {
  const ReplayReport report = Replay(recording::OpenRecording(Record(
      R"({"do":"joint_angles","left":[0.1,-0.5,0,0.9,0,1.1,0]}
{"do":"joint_velocities","left":[0.2,0.1,-0.3,0,0,0.1,0.5],"grippers":[-0.7,0.3],"head":0.3}
{"do":"wait","seconds":1}
{"do":"joint_velocities","left":[0,0,0,0,0,0,0],"head":0}
{"do":"wait","seconds":0.5})",
      /*with_robot=*/true)));
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_EQ(report.hash, final_hash_);
}

constexpr const char* kFaces = R"({"do":"wait","seconds":0.1}
{"do":"face","mood":"working"}
{"do":"wait","seconds":0.1}
{"do":"face","mood":"done"}
{"do":"wait","seconds":0.1})";

TEST_F(ReplayTest, TheTraceShowsTheFace) {
  const recording::Recording recording =
      recording::OpenRecording(Record(kFaces, /*with_robot=*/true));
  recording::TraceReader trace(recording);
  std::vector<robot::FaceExpression> face_expressions;
  while (const auto moment = trace.Next()) {
    if (face_expressions.empty() || face_expressions.back() != moment->face_expression)
      face_expressions.push_back(moment->face_expression);
  }
  EXPECT_EQ(face_expressions,
            (std::vector{robot::FaceExpression::kIdle, robot::FaceExpression::kWorking,
                         robot::FaceExpression::kDone}));
  EXPECT_FALSE(Replay(recording).first_difference.has_value());
}

TEST_F(ReplayTest, NoticesAnotherFace) {
  const auto directory = Record(kFaces, /*with_robot=*/true);
  std::string commands = Text(directory / "commands.jsonl");
  commands.replace(commands.find("done"), 4, "puzzled");
  Overwrite(directory / "commands.jsonl", commands);
  const ReplayReport report = Replay(recording::OpenRecording(directory));
  ASSERT_TRUE(report.first_difference.has_value());
  EXPECT_EQ(report.first_difference->object, "robot");
  EXPECT_EQ(report.first_difference->quantity, "mood");
  EXPECT_EQ(report.first_difference->recorded, "done");
  EXPECT_EQ(report.first_difference->replayed, "puzzled");
  ASSERT_EQ(report.state_differences.size(), 1u);
}

TEST_F(ReplayTest, UsesTheKindOfBodyThatTheRobotHad) {
  for (const bool is_kinematic : {true, false}) {
    const model::RobotBodyOptions body{.is_kinematic = is_kinematic,
                                       .grasps_by_friction = !is_kinematic};
    const auto directory = root_ / (is_kinematic ? "kinematic" : "friction");
    auto simulation = MakeSimulation(/*with_robot=*/true, kScene, body);
    {
      recorder::Recorder recorder(directory, {}, nullptr, *simulation);
      simulation->AddListener(&recorder);
      // Through the table and its blocks, closing.
      simulation->Apply(sim::JointVelocities{.arms = {{"left", {-0.4, 0.5, 0, 0, 0, 0, 0}}},
                                             .grippers = {{"left", -0.1}, {"right", -0.1}}});
      for (int i = 0; i < 120; ++i) simulation->Tick();
      simulation->RemoveListener(&recorder);
    }
    EXPECT_EQ(recording::OpenRecording(directory).robot()->body, body);
    EXPECT_FALSE(Replay(recording::OpenRecording(directory)).first_difference.has_value());

    std::string info = Text(directory / "demo.json");
    const std::string key = is_kinematic ? "\"kinematic\"" : "\"friction_grasp\"";
    info.replace(info.find(key), key.size(), is_kinematic ? "\"friction_grasp\"" : "\"kinematic\"");
    Overwrite(directory / "demo.json", info);
    EXPECT_TRUE(Replay(recording::OpenRecording(directory)).first_difference.has_value())
        << "of another body";
  }
}

TEST_F(ReplayTest, NamesTheFirstTickObjectAndQuantityThatDiffers) {
  const recording::Recording recording = RecordAndReword("[3.0,-2.0,3.0]", "[3.0,-2.1,3.0]");
  const ReplayReport report = Replay(recording, {.stops_at_difference = true});
  ASSERT_TRUE(report.first_difference.has_value());
  // Its target goes elsewhere at once (the hash sees that), the block itself a moment later.
  const std::uint64_t tick = recording.commands[2].tick + 1;
  EXPECT_EQ(report.first_difference->tick, tick);
  EXPECT_EQ(report.first_difference->object, "a");
  EXPECT_EQ(report.first_difference->quantity, "position");
  EXPECT_EQ(report.compared, (recording::TickRange{0, tick}));
}

TEST_F(ReplayTest, ReportsTheDeviationOfEverythingAndWhereItEnds) {
  const recording::Recording recording = RecordAndReword("[3.0,-2.0,1.51]", "[3.3,-2.0,1.51]");
  const ReplayReport report = Replay(recording);
  EXPECT_EQ(report.compared, recording::TicksOf(recording));
  ASSERT_GE(report.deviations.size(), 1u);
  // On the way down it lags; after it is set down, its deviation is that of the command.
  const Deviation& a = report.deviations[0];
  EXPECT_EQ(a.object, "a");
  EXPECT_NEAR(a.end->distance, 0.03, 0.002);
  EXPECT_GE(a.largest.size(), a.end->size());
  EXPECT_GT(a.tick, report.first_difference->tick);
  EXPECT_TRUE(report.refused.empty());
}

TEST_F(ReplayTest, ContinuesAfterRefusedCommandsAndReportsThem) {
  const recording::Recording recording = RecordAndReword("\"object\":\"a\"", "\"object\":\"z\"");
  const ReplayReport report = Replay(recording);
  EXPECT_EQ(report.first_difference->quantity, "command");
  // Nothing was grasped, so there is nothing to move or release.
  ASSERT_EQ(report.refused.size(), recording.commands.size());
  EXPECT_EQ(report.refused[0].line, 1u);
  EXPECT_EQ(report.refused[0].reason, report.first_difference->replayed);
  EXPECT_EQ(report.compared, recording::TicksOf(recording));
  ASSERT_FALSE(report.deviations.empty());
  EXPECT_EQ(report.deviations[0].object, "a");
  EXPECT_GT(report.deviations[0].end->distance, 0.3);
}

TEST_F(ReplayTest, ComparesOnlyTheRequestedRange) {
  const recording::Recording recording = RecordAndReword("[3.0,-2.0,1.51]", "[3.3,-2.0,1.51]");
  const std::uint64_t tick = Replay(recording).first_difference->tick;
  const double seconds = recording::SecondsInto(recording, tick);
  const ReplayReport before = Replay(recording, {.range = {.to = seconds - 0.1}});
  EXPECT_EQ(before.first_difference, std::nullopt);
  EXPECT_EQ(before.compared, (recording::TickRange{0, tick - 6}));
  const ReplayReport after =
      Replay(recording, {.range = {.from = seconds + 0.1, .to = seconds + 0.2}});
  EXPECT_EQ(after.first_difference->tick, tick + 6);
  EXPECT_EQ(after.compared, (recording::TickRange{tick + 6, tick + 12}));
  EXPECT_LE(after.deviations.at(0).tick, tick + 12);
}

TEST_F(ReplayTest, ReportsInvalidRanges) {
  const recording::Recording recording =
      recording::OpenRecording(Record("{\"do\":\"wait\",\"seconds\":2.05}"));
  EXPECT_EQ(ComplaintAbout({.from = 1, .to = 2.05}, recording), "");
  EXPECT_EQ(ComplaintAbout({.from = 2, .to = 1}, recording), "from is 2 s, which is after to, 1 s");
  EXPECT_EQ(ComplaintAbout({.from = -0.5}, recording), "from is -0.5 s, expected 0 or more");
  EXPECT_EQ(ComplaintAbout({.to = 3}, recording), "to is 3 s, but the recording is 2.05 s long");
  EXPECT_EQ(ComplaintAbout({.to = std::nan("")}, recording), "to is NaN s, expected 0 or more");
}

TEST_F(ReplayTest, CountsSecondsFromWhereTheDemonstrationBegan) {
  auto simulation = MakeSimulation(false);
  while (simulation->tick() < 30) simulation->Tick();
  {
    recorder::Recorder recorder(root_ / "demo", {}, nullptr, *simulation);
    simulation->AddListener(&recorder);
    while (simulation->tick() < 120) simulation->Tick();
  }
  const recording::Recording recording = recording::OpenRecording(root_ / "demo");
  EXPECT_EQ(recording::TicksOf(recording), (recording::TickRange{30, 120}));
  const ReplayReport report = Replay(recording, {.range = {.from = 0.5, .to = 1}});
  EXPECT_EQ(report.compared, (recording::TickRange{60, 90}));
  EXPECT_EQ(report.first_difference, std::nullopt);
}

TEST_F(ReplayTest, ABeginningThatIsNotTheTracesIsDamage) {
  const auto directory = Record();
  Json info = Json::parse(Text(directory / "demo.json"));
  info["start"]["tick"] = 1'000'000'000'000;
  Overwrite(directory / "demo.json", info.dump());
  EXPECT_THROW(Replay(recording::OpenRecording(directory)), InputError);
}

TEST_F(ReplayTest, OpensARecordingTruncatedByACrashAndReportsIt) {
  const auto directory = Record();
  const std::string commands = Text(directory / "commands.jsonl");
  Overwrite(directory / "commands.jsonl", commands.substr(0, commands.size() - 5));
  const std::string trace = Text(directory / "trace.bin");
  Overwrite(directory / "trace.bin", trace.substr(0, trace.size() / 3));

  const recording::Recording recording = recording::OpenRecording(directory);
  EXPECT_EQ(recording.cuts,
            (std::vector<std::string>{"the last line of commands.jsonl was cut and is skipped"}));
  const ReplayReport report = Replay(recording);
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_TRUE(report.is_cut);
  EXPECT_GT(report.ticks(), 20u);
}

TEST_F(ReplayTest, NoticesAPoseThatWasChangedInTheTrace) {
  const auto directory = Record();
  std::string trace = Text(directory / "trace.bin");
  // The height of the first object in the first record, after the header, the record's head and
  // counts, the object's index and whether it is there.
  const std::size_t header = 8 + 4 + 4 + 2 * (4 + 1) + 4, head = 8 + 8 + 1 + 3 * 4 + 4;
  const double lower = 0.04;
  std::memcpy(&trace[header + head + 4 + 1 + 2 * sizeof(double)], &lower, sizeof lower);
  Overwrite(directory / "trace.bin", trace);
  const auto difference = Replay(recording::OpenRecording(directory)).first_difference;
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
  EXPECT_THROW(Replay(recording::OpenRecording(directory)), InputError);
}

TEST_F(ReplayTest, NoticesACommandAfterTheEnd) {
  const auto directory = Record();
  std::ofstream(directory / "commands.jsonl", std::ios::app)
      << "{\"tick\":99999,\"hand\":\"left\",\"do\":\"release\"}\n";
  EXPECT_EQ(Replay(recording::OpenRecording(directory)).first_difference->quantity, "command");
}

TEST_F(ReplayTest, ReportsInvalidFiles) {
  EXPECT_EQ(Complaint(root_),
            root_.string() + ": is not a recording; expected a directory with a demo.json in it");
  const auto directory = Record();
  Overwrite(directory / "commands.jsonl", "{\"tick\":3,\"do\":\"fly\"}\n");
  EXPECT_EQ(Complaint(directory).substr(0, Complaint(directory).find(", expected")),
            (directory / "commands.jsonl").string() + ":1: \"do\" is \"fly\"");
}

TEST_F(ReplayTest, NeverOverwritesARecording) {
  const auto directory = Record();
  auto simulation = MakeSimulation(false);
  try {
    recorder::Recorder again(directory, {}, nullptr, *simulation);
    FAIL() << "it overwrote a recording";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().front().message,
              "exists already, expected a new directory; recordings are never overwritten");
  }
}

TEST_F(ReplayTest, OfASceneWithAMeshNeedsNoOtherFile) {
  const auto original = root_ / "original";
  std::filesystem::create_directories(original);
  std::filesystem::copy(DataFile("scenes/meshes"), original / "meshes");
  std::filesystem::copy(DataFile("scenes/meshes.xml"), original / "meshes.xml");
  {
    sim::Simulation simulation(scene_xml::LoadScene(original / "meshes.xml"));
    recorder::Recorder recorder(root_ / "demo", {}, nullptr, simulation);
    simulation.AddListener(&recorder);
    while (simulation.tick() < 120) simulation.Tick();
    final_hash_ = simulation.state_hash();
  }
  std::filesystem::remove_all(original);
  const ReplayReport report = Replay(recording::OpenRecording(root_ / "demo"));
  EXPECT_FALSE(report.first_difference);
  EXPECT_EQ(report.ticks(), 120u);
  EXPECT_EQ(report.hash, final_hash_);
}

}  // namespace
}  // namespace smile::replay
