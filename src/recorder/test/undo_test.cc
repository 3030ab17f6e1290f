// Effects of undo, redo and continuation on a recording.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>

#include "base/state_hash.h"
#include "recording/demonstration.h"
#include "recording/recording_history.h"
#include "recording/segment_files.h"
#include "recording/trace_reader.h"
#include "recording_fixture.h"
#include "replay/replay.h"
#include "scene_xml/scene_writer.h"
#include "sim/test/event_counter.h"
#include "sim/test/everything_scene.h"
#include "sim/test/random_hands.h"
#include "sim/test/undo_books.h"

namespace smile::recorder {
namespace {

/// An eye whose pictures differ if the visible state differs.
class HashingEye : public sim::Eye {
 public:
  const Image& Draw(const scene::VisualModel& model, const sim::ViewSample& sample) override {
    StateHash hash;
    for (const scene::Visual& visual : model.visuals) {
      const bool is_seen =
          visual.choice < 0 ||
          sample.state.variants[static_cast<std::size_t>(visual.choice)] == visual.variant;
      if (!is_seen) continue;
      const RigidTransform& X_WF = sample.state.poses[static_cast<std::size_t>(visual.frame)];
      for (double number : X_WF* visual.X_FV.translation()) hash.Add(number);
      hash.Add(visual.color.red);
    }
    image_.color = {std::uint8_t(hash.value()), std::uint8_t(hash.value() >> 8),
                    std::uint8_t(hash.value() >> 16)};
    return image_;
  }
  const sim::EyeSpec& spec() const override { return spec_; }

 private:
  sim::EyeSpec spec_{.width_px = 1, .height_px = 1};
  Image image_{.width_px = 1, .height_px = 1};
};

class UndoTest : public RecordingFixture {
 protected:
  /// As in a scene file: connected objects are together.
  static scene::SceneSpec Everything() {
    const std::string xml = scene_xml::WriteScene(sim::EverythingScene::MakeWithTools());
    return *scene_xml::ReadSceneText(xml, "everything.xml").scene;
  }

  /// Name and content of every file of the classic view.
  static std::map<std::string, std::string> ViewOf(const std::filesystem::path& demo) {
    std::map<std::string, std::string> view;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(demo)) {
      const std::string name = std::filesystem::relative(entry.path(), demo).string();
      const bool is_view = name == "frames.csv" || std::isdigit(name.front()) != 0;
      if (!is_view) continue;
      view[name] = entry.is_directory() ? "folder" : ReadFile(entry.path(), 1 << 20);
    }
    return view;
  }

  /// Records the path on which the recording ended, as if nothing had ever been undone.
  std::map<std::string, std::string> ViewWithoutUndo(const recording::Recording& recording,
                                                     std::uint64_t last_tick) {
    HashingEye eye;
    sim::Simulation simulation(recording.start_model);
    const auto directory = root_ / ("straight" + std::to_string(num_straight_++));
    Recorder recorder(directory, {.frames_per_second = recording.info.frames_per_second}, &eye,
                      simulation);
    simulation.AddListener(&recorder);
    std::size_t next = 0;
    while (true) {
      for (; next < recording.commands.size() && recording.commands[next].tick == simulation.tick();
           ++next) {
        EXPECT_EQ(simulation.Apply(recording.commands[next].command), std::nullopt);
      }
      if (simulation.tick() == last_tick) break;
      simulation.Tick();
    }
    recorder.Flush();
    return ViewOf(directory);
  }

  /// A simulation that was recorded from its beginning has the history of its recording: actions
  /// have the numbers of steps.
  static void ExpectOneHistory(const sim::ActionHistory& history,
                               const recording::Recording& recording) {
    const std::vector<recording::Segment> steps = recording::HistoryOf(recording);
    EXPECT_EQ(std::ranges::count_if(steps, &recording::Segment::is_on_path),
              std::ssize(history.done()));
    for (const sim::Action& action : history.done()) {
      ASSERT_LT(action.id.value, steps.size());
      const recording::Segment& step = steps[action.id.value];
      EXPECT_TRUE(step.is_on_path);
      EXPECT_EQ(step.begin.tick, action.tick);
      EXPECT_EQ(recording::WordsOf(step),
                action.summary ? sim::WordsOf(*action.summary) : "the start");
    }
    for (const sim::Action& action : history.undone()) {
      ASSERT_LT(action.id.value, steps.size());
      EXPECT_FALSE(steps[action.id.value].is_on_path);
      EXPECT_EQ(recording::WordsOf(steps[action.id.value]), sim::WordsOf(*action.summary));
    }
    ExpectSameSegments(history.done(), recording);
  }

  /// Done actions are also the segments of editing and the texts of the classic view.
  static void ExpectSameSegments(std::span<const sim::Action> done,
                                 const recording::Recording& recording) {
    const recording::Demonstration demonstration = recording::DemonstrationOf(recording);
    ASSERT_EQ(demonstration.segments.size(), done.size());
    for (std::size_t i = 0; i < done.size(); ++i) {
      std::vector<sim::TimedCommand> commands;
      for (const recording::SegmentCommand& logged : demonstration.segments[i].commands) {
        commands.push_back({done[i].tick + logged.offset, logged.command});
      }
      EXPECT_EQ(commands, done[i].commands) << "of segment " << i;
      EXPECT_TRUE(std::filesystem::exists(
          recording::SegmentText(recording.directory, static_cast<int>(i))));
    }
    EXPECT_FALSE(std::filesystem::exists(
        recording::SegmentText(recording.directory, static_cast<int>(done.size()))));
  }

  /// Random commands of hands, with undo and redo between them.
  static void ActAtRandom(sim::Simulation* simulation, unsigned seed, int num_steps) {
    sim::RandomHands hands(seed, /*changes_objects=*/true);
    std::mt19937 random(seed);
    for (int i = 0; i < num_steps; ++i) {
      const auto dice = random() % 8;
      if (dice == 0) {
        (void)simulation->Apply(sim::Undo());
      } else if (dice == 1) {
        (void)simulation->Apply(sim::Redo());
      } else {
        (void)simulation->Apply(hands.Next(*simulation));
      }
      for (unsigned ticks = random() % 3 * 4; ticks > 0; --ticks) simulation->Tick();
    }
    simulation->Tick();  // what was done last shows in its hash
  }

  int num_straight_ = 0;
};

class UndoProperty : public UndoTest, public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, UndoProperty, testing::Range(1u, 4u));

TEST_P(UndoProperty, UndoneActionsLeaveTheViewAndTheRestReplays) {
  HashingEye eye;
  sim::Simulation simulation(Everything());
  Recorder recorder(root_ / "demo", {.frames_per_second = 12}, &eye, simulation);
  simulation.AddListener(&recorder);
  ActAtRandom(&simulation, GetParam(), 60);
  recorder.Flush();

  const recording::Recording recording = recording::OpenRecording(root_ / "demo");
  EXPECT_TRUE(recording.cuts.empty());
  EXPECT_LT(recording.commands.size() + 5, recording.log.lines().size());
  const replay::ReplayReport report = replay::Replay(recording);
  EXPECT_EQ(report.first_difference, std::nullopt);
  EXPECT_EQ(report.hash, simulation.state_hash());
  EXPECT_EQ(ViewOf(root_ / "demo"), ViewWithoutUndo(recording, simulation.tick()));
  ExpectOneHistory(simulation.history(), recording);
}

TEST_P(UndoProperty, ContinuesFromAnyMomentAsIfNeverStopped) {
  {
    HashingEye eye;
    sim::Simulation simulation(Everything());
    Recorder recorder(root_ / "demo", {.frames_per_second = 12}, &eye, simulation);
    simulation.AddListener(&recorder);
    ActAtRandom(&simulation, GetParam(), 40);
  }
  std::mt19937 random(GetParam());
  for (int i = 0; i < 4; ++i) {
    const recording::Recording recording = recording::OpenRecording(root_ / "demo");
    // A moment after any line, or within any step, also of an undone branch.
    const std::size_t line = random() % (recording.log.lines().size() + 1);
    recording::HistoryPoint from = recording.log.After(line);
    if (i % 2 == 1) {
      const std::vector<recording::Segment> steps = recording::HistoryOf(recording);
      const recording::Segment& step = steps[random() % steps.size()];
      from = *recording::HistoryPointIn(recording, step,
                                        random() % (step.end.tick - step.begin.tick + 1));
    }
    HashingEye eye;
    sim::Simulation simulation(recording.start_model);
    const auto recorder = Recorder::Continue(root_ / "demo", from, &eye, &simulation);
    EXPECT_EQ(simulation.tick(), from.tick);
    simulation.AddListener(recorder.get());
    ActAtRandom(&simulation, 100 * GetParam() + static_cast<unsigned>(i), 12);
    recorder->Flush();

    const recording::Recording now = recording::OpenRecording(root_ / "demo");
    const replay::ReplayReport report = replay::Replay(now);
    ASSERT_EQ(report.first_difference, std::nullopt)
        << "went on after line " << from.line << " at tick " << from.tick;
    ASSERT_EQ(report.hash, simulation.state_hash());
    ASSERT_EQ(ViewOf(root_ / "demo"), ViewWithoutUndo(now, simulation.tick()));
  }
}

int NumberFrom(const char* variable, int usual) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : usual;
}

/// tools/random_sessions.sh asks for more and longer ones.
TEST_F(UndoTest, RandomSessionsReplayIdenticallyAndUndoExactly) {
  const int num_sessions = NumberFrom("SMILE_SESSIONS", 1);
  const int num_ticks = NumberFrom("SMILE_SESSION_SECONDS", 6) * sim::kTicksPerSecond;
  sim::EventCounter counter;
  for (int session = 1; session <= num_sessions; ++session) {
    SCOPED_TRACE("session " + std::to_string(session));
    const auto demo = root_ / ("session" + std::to_string(session));
    sim::Simulation simulation(Everything());
    Recorder recorder(demo, {}, nullptr, simulation);
    simulation.AddListener(&recorder);
    sim::UndoBooks books(simulation);
    simulation.AddListener(&books);
    simulation.AddListener(&counter);
    sim::RandomHands hands(static_cast<unsigned>(session), /*changes_objects=*/true);
    std::mt19937 random(static_cast<unsigned>(session));
    for (int i = 0; i < num_ticks; ++i) {
      const auto dice = random() % 40;
      if (dice == 0) {
        (void)simulation.Apply(sim::Undo());
      } else if (dice == 1) {
        (void)simulation.Apply(sim::Redo());
      } else if (dice < 8) {
        (void)simulation.Apply(hands.Next(simulation));
      }
      simulation.Tick();
    }
    EXPECT_GT(books.num_undone(), 0);
    const recording::Recording recording = recording::OpenRecording(demo);
    const replay::ReplayReport report = replay::Replay(recording);
    ASSERT_EQ(report.first_difference, std::nullopt);
    ASSERT_EQ(report.hash, simulation.state_hash());
    ExpectOneHistory(simulation.history(), recording);
  }
  EXPECT_GT(counter.num_events[sim::EventKind::kUsed], 0);
  EXPECT_GT(counter.num_events[sim::EventKind::kPressed], 0);
}

TEST_F(UndoTest, TheLogKeepsWhatWasUndone) {
  auto simulation = MakeSimulation(false);
  Recorder recorder(root_ / "demo", {}, nullptr, *simulation);
  simulation->AddListener(&recorder);
  using sim::HandName;
  ASSERT_FALSE(simulation->Apply(sim::Grasp{.hand = HandName::kLeft, .object = "a"}));
  for (int i = 0; i < 30; ++i) simulation->Tick();
  ASSERT_FALSE(simulation->Apply(sim::Undo()));
  EXPECT_EQ(simulation->tick(), 0u);
  ASSERT_FALSE(simulation->Apply(sim::Grasp{.hand = HandName::kRight, .object = "b"}));
  EXPECT_EQ(*simulation->Apply(sim::Redo()), "nothing to redo in this recording");

  EXPECT_EQ(Lines(root_ / "demo" / "commands.jsonl"),
            (std::vector<std::string>{R"({"tick":0,"hand":"left","do":"grasp","object":"a"})",
                                      R"({"tick":30,"do":"undo","to":{"line":0,"tick":0}})",
                                      R"({"tick":0,"hand":"right","do":"grasp","object":"b"})"}));
  const recording::Recording recording = recording::OpenRecording(root_ / "demo");
  ASSERT_EQ(recording.commands.size(), 1u);
  EXPECT_EQ(recording.commands[0].line, 3u);
  EXPECT_EQ(recording.log.PathTo(1).size(), 1u);
}

TEST_F(UndoTest, BeginsAnyTimeAlsoWhileHolding) {
  auto simulation = MakeSimulation(false);
  using sim::HandName;
  ASSERT_FALSE(simulation->Apply(sim::Grasp{.hand = HandName::kLeft, .object = "a"}));
  ASSERT_FALSE(simulation->Apply(sim::MoveTo{.hand = HandName::kLeft, .p_WH = {0, -0.2, 0.4}}));
  for (int i = 0; i < 47; ++i) simulation->Tick();

  Recorder recorder(root_ / "demo", {}, nullptr, *simulation);
  simulation->AddListener(&recorder);
  EXPECT_NE(simulation->Apply(sim::Undo())->find("nothing to undo in this recording"),
            std::string::npos);
  ASSERT_FALSE(simulation->Apply(sim::Release{.hand = HandName::kLeft}));
  for (int i = 0; i < 60; ++i) simulation->Tick();

  EXPECT_EQ(Lines(root_ / "demo" / "0.txt")[2], "0,grasp,LeftHand,a");
  EXPECT_EQ(Lines(root_ / "demo" / "1.txt")[0], "1,release,LeftHand");
  const recording::Recording recording = recording::OpenRecording(root_ / "demo");
  EXPECT_EQ(recording.info.start, (recording::HistoryPoint{.line = 2, .tick = 47}));
  const replay::ReplayReport report = replay::Replay(recording);
  EXPECT_EQ(report.first_difference, std::nullopt);
  EXPECT_EQ(report.ticks(), 60u);
  EXPECT_EQ(report.hash, simulation->state_hash());
}

TEST_F(UndoTest, DoesNotBeginWithoutTheHistoryOfTheState) {
  auto simulation = MakeSimulation(false);
  simulation->Restore(simulation->Save());
  EXPECT_THROW(Recorder(root_ / "none", {}, nullptr, *simulation), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(root_ / "none"));
}

TEST_F(UndoTest, AnUndoThatDidNotReachTheTraceIsLeftOut) {
  const auto demo = Record();
  const std::size_t num_commands = recording::OpenRecording(demo).commands.size();
  std::ofstream(demo / "commands.jsonl", std::ios::app)
      << R"({"do":"undo","tick":9999,"to":{"line":1,"tick":3}})"
      << "\n";
  const recording::Recording recording = recording::OpenRecording(demo);
  EXPECT_EQ(recording.cuts, (std::vector<std::string>{"the last undo was cut and is skipped"}));
  EXPECT_EQ(recording.commands.size(), num_commands);
  EXPECT_EQ(replay::Replay(recording).first_difference, std::nullopt);
}

TEST_F(UndoTest, NamesTheLineOfAnInvalidReturn) {
  const auto demo = Record();
  for (const auto& [line, message] : std::map<std::string, std::string>{
           {R"({"do":"undo","tick":9999,"to":{"line":99,"tick":3}})", "\"line\" is 99"},
           {R"({"do":"redo","tick":9999,"to":{"line":3,"tick":0}})", "\"to\" is tick 0"},
           {R"({"do":"undo","tick":9999})", "\"to\" is null"},
           {R"({"do":"start","tick":9999})", "\"do\" is \"start\""}}) {
    const std::string log = ReadFile(demo / "commands.jsonl", 1 << 20);
    std::ofstream(demo / "commands.jsonl", std::ios::app) << line << "\n";
    try {
      (void)recording::OpenRecording(demo);
      ADD_FAILURE() << "took " << line;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("commands.jsonl:6: " + message), std::string::npos)
          << error.what();
    }
    std::ofstream(demo / "commands.jsonl") << log;
  }
}

}  // namespace
}  // namespace smile::recorder
