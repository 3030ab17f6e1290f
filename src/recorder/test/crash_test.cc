// The complete part of a recording opens again, however the program ended.

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <fstream>
#include <random>

#include "recorder/recording_controller.h"
#include "recording/recording_history.h"
#include "recording/trace_reader.h"
#include "recording_fixture.h"
#include "replay/replay.h"

namespace smile::recorder {
namespace {

class CrashTest : public RecordingFixture {
 protected:
  /// Two hands work on the pair of blocks at random.
  static void Work(sim::Simulation* simulation, unsigned seed, int num_steps) {
    std::mt19937 random(seed);
    for (int i = 0; i < num_steps; ++i) {
      const sim::HandName hand = random() % 2 ? sim::HandName::kLeft : sim::HandName::kRight;
      switch (random() % 6) {
        case 0:
          (void)simulation->Apply(sim::Grasp{.hand = hand, .object = random() % 2 ? "a" : "b"});
          break;
        case 1:
          (void)simulation->Apply(sim::Release{.hand = hand});
          break;
        case 2:
          (void)simulation->Apply(sim::Undo());
          break;
        case 3:
          (void)simulation->Apply(sim::Redo());
          break;
        default: {
          const double x = std::uniform_real_distribution(-0.5, 0.5)(random);
          (void)simulation->Apply(sim::MoveTo{.hand = hand, .p_WH = {x, -0.2, 0.3}});
        }
      }
      for (unsigned ticks = random() % 4; ticks > 0; --ticks) simulation->Tick();
    }
  }

  /// Runs a function in a process of its own; returns its id.
  template <class Part>
  static pid_t Fork(const Part& part) {
    const pid_t child = fork();
    if (child != 0) return child;
    part();
    _exit(0);
  }

  /// Opens the recording and checks that it is sound.
  /// @returns the number of ticks; nullopt if the recording had not begun.
  std::optional<std::uint64_t> CheckSound(const std::filesystem::path& demo) {
    if (!recording::IsRecording(demo)) return std::nullopt;
    const recording::Recording recording = recording::OpenRecording(demo);
    const replay::ReplayReport report = replay::Replay(recording);
    EXPECT_EQ(report.first_difference, std::nullopt);
    EXPECT_FALSE(recording::HistoryOf(recording).empty());

    // It can also be continued.
    auto simulation = MakeSimulation(false);
    const std::vector<recording::Segment> steps = recording::HistoryOf(recording);
    std::size_t last = steps.size() - 1;
    while (!steps[last].is_on_path) --last;
    const auto recorder = Recorder::Continue(demo, steps[last].end, nullptr, simulation.get());
    simulation->AddListener(recorder.get());
    Work(simulation.get(), 7, 6);
    simulation->Tick();  // what was done last shows in its hash
    const recording::Recording longer = recording::OpenRecording(demo);
    EXPECT_TRUE(longer.cuts.empty());
    const replay::ReplayReport again = replay::Replay(longer);
    EXPECT_EQ(again.first_difference, std::nullopt);
    EXPECT_EQ(again.hash, simulation->state_hash());
    return report.ticks();
  }
};

TEST_F(CrashTest, AKilledProcessLosesNoCompleteRecord) {
  std::mt19937 random(1);
  int num_begun = 0;
  std::uint64_t most_ticks = 0;
  for (int i = 0; i < 50; ++i) {
    const auto demo = root_ / ("killed" + std::to_string(i));
    const pid_t child = Fork([&] {
      auto simulation = MakeSimulation(false);
      Recorder recorder(demo, {}, nullptr, *simulation);
      simulation->AddListener(&recorder);
      Work(simulation.get(), static_cast<unsigned>(i), 1'000'000);
    });
    // Every other one is killed when it is at work, however long a busy machine takes to begin.
    while (i % 2 == 0 && !recording::IsRecording(demo)) usleep(1000);
    usleep(1000 + random() % 60'000);
    ASSERT_EQ(kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
    const auto ticks = CheckSound(demo);
    if (!ticks) continue;
    ++num_begun;
    most_ticks = std::max(most_ticks, *ticks);
  }
  EXPECT_GE(num_begun, 25);
  EXPECT_GT(most_ticks, 5u);
}

/// Notes the lengths of log and trace after each write.
class SizeNoter : public sim::Listener {
 public:
  struct Sizes {
    std::uintmax_t log = 0, trace = 0;
    bool operator==(const Sizes&) const = default;
  };

  explicit SizeNoter(std::filesystem::path demo) : demo_(std::move(demo)) { Note(); }
  void OnCommand(const sim::Simulation&, const sim::Command&) override { Note(); }
  void OnEvent(const sim::Simulation&, const sim::Event&) override { Note(); }
  void OnMove(const sim::Simulation&, sim::ActionId, sim::ActionId) override { NoteReturn(); }
  void OnTick(const sim::Simulation&) override { Note(); }

  const std::vector<Sizes>& sizes() const { return sizes_; }

 private:
  void Note() {
    const Sizes now{std::filesystem::file_size(demo_ / "commands.jsonl"),
                    std::filesystem::file_size(demo_ / "trace.bin")};
    if (sizes_.empty() || sizes_.back() != now) sizes_.push_back(now);
  }
  /// Its line is in the log before it is in the trace.
  void NoteReturn() {
    const std::uintmax_t trace = sizes_.back().trace;
    Note();
    const Sizes after = sizes_.back();
    sizes_.back().trace = trace;
    sizes_.push_back(after);
  }

  std::filesystem::path demo_;
  std::vector<Sizes> sizes_;
};

TEST_F(CrashTest, TheLastCompleteRecordIsTheEnd) {
  const auto demo = root_ / "demo", cut = root_ / "cut";
  std::vector<SizeNoter::Sizes> sizes;
  {
    auto simulation = MakeSimulation(false);
    Recorder recorder(demo, {}, nullptr, *simulation);
    simulation->AddListener(&recorder);
    SizeNoter noter(demo);
    simulation->AddListener(&noter);
    Work(simulation.get(), 5, 60);
    sizes = noter.sizes();
  }
  for (std::size_t i = 0; i < sizes.size(); i += 2) {
    SCOPED_TRACE("log of " + std::to_string(sizes[i].log) + " and trace of " +
                 std::to_string(sizes[i].trace) + " bytes");
    std::filesystem::remove_all(cut);
    std::filesystem::copy(demo, cut, std::filesystem::copy_options::recursive);
    std::filesystem::resize_file(cut / "commands.jsonl", sizes[i].log);
    std::filesystem::resize_file(cut / "trace.bin", sizes[i].trace);
    ASSERT_TRUE(CheckSound(cut).has_value());
  }
}

TEST_F(CrashTest, AFullDiskEndsTheRecordingNotTheSimulation) {
  // No file may grow beyond these many bytes; what was meant to is cut there.
  for (const rlim_t limit : {9000, 20'000, 31'007, 50'123}) {
    const auto demo = root_ / ("full" + std::to_string(limit));
    const pid_t child = Fork([&] {
      signal(SIGXFSZ, SIG_IGN);
      const rlimit size{limit, limit};
      setrlimit(RLIMIT_FSIZE, &size);
      auto simulation = MakeSimulation(false);
      RecordingController controller(simulation.get(), {});
      controller.StartIn(demo, *simulation);
      Work(simulation.get(), 3, 2000);
      const bool is_reported =
          controller.failure() && controller.failure()->find("File too large") != std::string::npos;
      _exit(is_reported && !controller.is_recording() ? 42 : 1);
    });
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(WEXITSTATUS(status), 42) << limit;
    EXPECT_TRUE(CheckSound(demo).has_value()) << limit;
  }
}

TEST_F(CrashTest, ADirectoryThatCannotBeWrittenIsARefusal) {
  auto simulation = MakeSimulation(false);
  std::filesystem::create_directories(root_ / "file");
  std::ofstream(root_ / "notafolder") << "x";
  RecordingController controller(simulation.get(), {.root = root_ / "notafolder"});
  const auto refusal = simulation->Apply(sim::StartRecording{.name = "demo"});
  ASSERT_TRUE(refusal.has_value());
  EXPECT_NE(refusal->find("notafolder"), std::string::npos) << *refusal;
  EXPECT_FALSE(controller.is_recording());
}

}  // namespace
}  // namespace smile::recorder
