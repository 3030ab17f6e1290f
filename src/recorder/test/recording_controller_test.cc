#include "recorder/recording_controller.h"

#include "recording/recording_history.h"
#include "recording_fixture.h"
#include "replay/replay.h"

namespace smile::recorder {
namespace {

using sim::HandName;

class RecordingControllerTest : public RecordingFixture {
 protected:
  RecordingControllerTest()
      : simulation_(MakeSimulation(false)), controller_(simulation_.get(), {.root = root_}) {}

  void Do(const sim::Command& command, int ticks = 0) {
    const auto refusal = simulation_->Apply(command);
    ASSERT_EQ(refusal, std::nullopt) << *refusal;
    for (int i = 0; i < ticks; ++i) simulation_->Tick();
  }

  std::unique_ptr<sim::Simulation> simulation_;
  RecordingController controller_;
};

TEST_F(RecordingControllerTest, EveryRecordingHasADirectoryOfItsOwn) {
  EXPECT_EQ(*simulation_->Apply(sim::FinishRecording()), "no recording is in progress");
  Do(sim::StartRecording{.name = "take", .title = "first"}, 3);
  EXPECT_NE(simulation_->Apply(sim::StartRecording())->find("already recording"),
            std::string::npos);
  Do(sim::FinishRecording());
  Do(sim::StartRecording{.name = "take"}, 5);
  Do(sim::FinishRecording());
  Do(sim::StartRecording(), 1);
  EXPECT_EQ(controller_.directories(),
            (std::vector<std::filesystem::path>{root_ / "take", root_ / "take-2", root_ / "pair"}));
  EXPECT_EQ(recording::OpenRecording(root_ / "take").info.title, "first");
  EXPECT_EQ(recording::OpenRecording(root_ / "take-2").info.title, "");
  EXPECT_EQ(recording::OpenRecording(root_ / "take-2").info.start.tick, 3u);
}

TEST_F(RecordingControllerTest, ADirectoryThatIsRemovedEndsTheRecording) {
  Do(sim::StartRecording{.name = "take"}, 10);
  std::filesystem::remove_all(root_ / "take");
  EXPECT_NE(simulation_->Apply(sim::FinishRecording())->find("take/demo.json: was removed"),
            std::string::npos);
  EXPECT_FALSE(controller_.is_recording());
  Do(sim::StartRecording{.name = "take"}, 10);
  EXPECT_EQ(controller_.failure(), std::nullopt);
  std::filesystem::remove_all(root_ / "take");
  for (int i = 0; i < sim::kTicksPerSecond; ++i) simulation_->Tick();
  EXPECT_FALSE(controller_.is_recording()) << "it is noticed within a second";
  EXPECT_NE(controller_.failure()->find("was removed"), std::string::npos);
}

TEST_F(RecordingControllerTest, ARecordingIsOfOneSceneAndBeginsWithTheLoadedOne) {
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"}, 20);
  scene::SceneSpec other = simulation_->scene();
  other.name = "other";
  other.objects.pop_back();
  const sim::Load load{std::make_shared<const scene::SceneSpec>(other)};
  Do(load, 10);
  Do(sim::Grasp{.hand = HandName::kRight, .object = "a"}, 10);
  Do(sim::StartRecording(), 10);
  EXPECT_EQ(*simulation_->Apply(load),
            "a recording is in progress and contains one scene only; finish it first");
  EXPECT_NE(simulation_->Apply(sim::Undo()), std::nullopt);
  Do(sim::Release{.hand = HandName::kRight}, 30);
  Do(sim::FinishRecording());
  const recording::Recording take = recording::OpenRecording(root_ / "other");
  EXPECT_EQ(take.start_scene(), other);
  EXPECT_EQ(take.info.start.tick, 20u);
  EXPECT_EQ(replay::Replay(take).first_difference, std::nullopt);
  // A log contains no load: the visible part of a recording is of one scene.
  WriteFile(root_ / "other/commands.jsonl", R"({"tick":0,"do":"load","xml":""})"
                                            "\n");
  EXPECT_THROW((void)recording::OpenRecording(root_ / "other"), InputError);
  for (int i = 0; i < 3; ++i) Do(sim::Undo());
  EXPECT_EQ(simulation_->tick(), 20u);
  EXPECT_EQ(simulation_->scene().name, "pair");
}

TEST_F(RecordingControllerTest, NoNameLeadsOutOfItsFolder) {
  for (const char* name : {"../up", "/tmp/x", ".hidden", "a/b", "a\\b", "a\nb", ".."}) {
    const auto refusal = simulation_->Apply(sim::StartRecording{.name = name});
    ASSERT_TRUE(refusal.has_value()) << name;
    EXPECT_NE(refusal->find("expected up to 100 letters"), std::string::npos);
  }
  EXPECT_TRUE(std::filesystem::is_empty(root_));
}

TEST_F(RecordingControllerTest, ABlankTitleIsRefused) {
  EXPECT_EQ(*simulation_->Apply(sim::StartRecording{.name = "take", .title = " \t "}),
            recording::BlankTitle());
  EXPECT_TRUE(std::filesystem::is_empty(root_));
  EXPECT_THROW(Recorder(root_ / "demo", {.title = "  "}, nullptr, *simulation_),
               std::invalid_argument);
}

TEST_F(RecordingControllerTest, ActionsUndoneBeforeTheStartAreOmitted) {
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"}, 20);
  Do(sim::Undo());
  Do(sim::Grasp{.hand = HandName::kRight, .object = "b"}, 20);
  Do(sim::Release{.hand = HandName::kRight}, 5);
  Do(sim::Undo());
  Do(sim::Redo(), 7);
  Do(sim::StartRecording{.name = "take"}, 10);
  const recording::Recording recording = recording::OpenRecording(root_ / "take");
  EXPECT_EQ(recording.commands.size(), 2u);
  EXPECT_EQ(recording.info.start, (recording::HistoryPoint{.line = 2, .tick = 32}));
  const replay::ReplayReport report = replay::Replay(recording);
  EXPECT_EQ(report.first_difference, std::nullopt);
  EXPECT_EQ(report.hash, simulation_->state_hash());
}

TEST_F(RecordingControllerTest, AfterTheFinishTheWorldCanBeUndoneButNotTheRecording) {
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"}, 20);
  Do(sim::StartRecording{.name = "take"}, 5);
  EXPECT_NE(simulation_->Apply(sim::Undo()), std::nullopt);
  Do(sim::FinishRecording());
  Do(sim::Undo());
  EXPECT_EQ(simulation_->tick(), 0u);
  EXPECT_EQ(replay::Replay(recording::OpenRecording(root_ / "take")).ticks(), 5u);
}

TEST_F(RecordingControllerTest, ARecordingInProgressCannotBeContinued) {
  Do(sim::StartRecording{.name = "take"}, 10);
  auto other = MakeSimulation(false);
  const auto continue_recording = [&] {
    return Recorder::Continue(root_ / "take", {.line = 0, .tick = 5}, nullptr, other.get());
  };
  EXPECT_THROW(continue_recording(), std::runtime_error);
  Do(sim::FinishRecording());
  EXPECT_EQ(recording::OpenRecording(root_ / "take").log.lines().size(), 0u);
  EXPECT_NE(continue_recording(), nullptr);
}

TEST_F(RecordingControllerTest, TheHistoryIncludesUndoneSteps) {
  Do(sim::StartRecording{.name = "take"}, 10);
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"}, 10);
  Do(sim::Release{.hand = HandName::kLeft}, 10);
  Do(sim::Undo(), 2);
  Do(sim::Point{.hand = HandName::kRight, .part = "b"}, 10);
  Do(sim::FinishRecording());
  const std::vector<recording::Segment> steps =
      recording::HistoryOf(recording::OpenRecording(root_ / "take"));
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_EQ(recording::WordsOf(steps[0]), "the start");
  EXPECT_EQ(recording::WordsOf(steps[1]), "left hand takes a");
  EXPECT_EQ(recording::WordsOf(steps[2]), "left hand puts a on the table");
  EXPECT_EQ(recording::WordsOf(steps[3]), "right hand points at b");
  EXPECT_EQ(steps[3].parent, 1u);
  EXPECT_FALSE(steps[2].is_on_path);
  EXPECT_TRUE(steps[1].is_on_path && steps[3].is_on_path);
  EXPECT_EQ(steps[2].end, (recording::HistoryPoint{.line = 2, .tick = 30}));
  EXPECT_EQ(steps[1].end, (recording::HistoryPoint{.line = 3, .tick = 22}));
  EXPECT_EQ(steps[3].end, (recording::HistoryPoint{.line = 4, .tick = 32}));
}

TEST_F(RecordingControllerTest, TheHistoryNamesFromTheLogWhatTheTraceLacks) {
  Do(sim::StartRecording{.name = "take"}, 10);
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"}, 10);
  Do(sim::Release{.hand = HandName::kLeft}, 10);
  Do(sim::FinishRecording());
  const recording::Recording recording = recording::OpenRecording(root_ / "take");
  const std::filesystem::path trace = root_ / "take" / "trace.bin";
  std::filesystem::resize_file(trace, std::filesystem::file_size(trace) / 2);
  const std::vector<recording::Segment> steps = recording::HistoryOf(recording);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(recording::WordsOf(steps[1]), "left hand takes a");
  EXPECT_EQ(recording::WordsOf(steps[2]), "left hand releases a");
}

TEST_F(RecordingControllerTest, AStepOnThePathEndsWhereTheNextBegins) {
  Do(sim::StartRecording{.name = "take"}, 10);
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"}, 10);
  Do(sim::Release{.hand = HandName::kLeft}, 10);
  Do(sim::FinishRecording());
  const auto steps = [this] {
    return recording::HistoryOf(recording::OpenRecording(root_ / "take"));
  };
  const auto continue_recording = [this](const recording::HistoryPoint& from,
                                         const sim::Command& command) {
    const auto simulation = MakeSimulation(false);
    const auto recorder = Recorder::Continue(root_ / "take", from, nullptr, simulation.get());
    simulation->AddListener(recorder.get());
    EXPECT_EQ(simulation->Apply(command), std::nullopt);
    simulation->Tick();
  };
  const recording::HistoryPoint drop_end = steps()[2].end;
  continue_recording({.line = 1, .tick = 14}, sim::Release{.hand = HandName::kLeft});
  EXPECT_EQ(steps()[1].end, (recording::HistoryPoint{.line = 3, .tick = 14}));
  // Back to the abandoned branch: the attempt in between does not shorten the path to it.
  continue_recording(drop_end, sim::Point{.hand = HandName::kRight, .part = "b"});
  EXPECT_EQ(steps()[1].end, steps()[2].begin);
  EXPECT_EQ(steps()[1].end, (recording::HistoryPoint{.line = 1, .tick = 20}));
}

}  // namespace
}  // namespace smile::recorder
