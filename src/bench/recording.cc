#include "bench/internal_recording.h"

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "base/files.h"
#include "bench/internal_scenes.h"
#include "bench/scratch_folder.h"
#include "library/playback.h"
#include "recorder/recorder.h"
#include "recording/trace_reader.h"
#include "replay/replay.h"
#include "sim/script.h"
#include "sim/simulation.h"

namespace smile::bench {
namespace {

using sim::HandName;

/// Moves a block to and fro with a hand; all others are at rest.
void CarryOn(sim::Simulation* simulation) {
  const std::uint64_t tick = simulation->tick();
  if (tick % 60 != 0) return;
  if (tick == 0) {
    simulation->Apply(sim::Grasp{.hand = HandName::kLeft, .object = "Blue1"});
  }
  const double x = tick / 60 % 2 == 0 ? 0.3 : -0.3;
  simulation->Apply(sim::MoveTo{.hand = HandName::kLeft, .p_WH = {x, -0.1, 0.3}, .speed = 0.4});
}

/// Returns the size of all files of a recording [bytes].
std::uintmax_t SizeOf(const std::filesystem::path& demo) {
  std::uintmax_t bytes = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(demo)) {
    if (file.is_regular_file()) bytes += file.file_size();
  }
  return bytes;
}

/// Reports the size of a recording per hour of demonstrating.
void ReportSize(benchmark::State& state, const std::filesystem::path& demo, double seconds) {
  state.counters["MB_per_hour"] = static_cast<double>(SizeOf(demo)) / 1e6 / seconds * 3600;
}

/// Measures a tick while a hand moves a block, with or without the recording of it.
void TickOfAHandAtWork(benchmark::State& state, bool is_recorded) {
  const ScratchFolder folder;
  sim::Simulation simulation(UmScene());
  std::optional<recorder::Recorder> recorder;
  if (is_recorded) {
    recorder.emplace(folder.path() / "demo", recorder::RecorderOptions(), nullptr, simulation);
    simulation.AddListener(&*recorder);
  }
  for (auto _ : state) {
    CarryOn(&simulation);
    simulation.Tick();
  }
  if (is_recorded) ReportSize(state, folder.path() / "demo", simulation.seconds());
}

/// Recording of eight hours: a hand works for the first hour, then everything rests.
class LongRecording {
 public:
  static constexpr double kSeconds = 8 * 3600;

  LongRecording() {
    sim::Simulation simulation(UmScene());
    recorder::Recorder recorder(demo(), {}, nullptr, simulation);
    simulation.AddListener(&recorder);
    while (simulation.seconds() < kSeconds) {
      if (simulation.seconds() < kSeconds / 8) CarryOn(&simulation);
      simulation.Tick();
    }
    simulation.RemoveListener(&recorder);
  }
  std::filesystem::path demo() const { return folder_.path() / "demo"; }

 private:
  ScratchFolder folder_;
};

/// Measures the opening of a recording of eight hours, and the first look at its middle.
void OpenEightHours(benchmark::State& state) {
  // Made once, and only if it is measured.
  static const LongRecording recording;
  for (auto _ : state) {
    library::Playback playback("demo", recording.demo());
    playback.Seek(LongRecording::kSeconds / 2);
    if (playback.length() < LongRecording::kSeconds) state.SkipWithError("the end is missing");
  }
  recording::TraceReader trace(recording::OpenRecording(recording.demo()));
  (void)trace.LastTick();
  state.counters["kB_read_of_trace"] = static_cast<double>(trace.bytes_read()) / 1e3;
  ReportSize(state, recording.demo(), LongRecording::kSeconds);
}

/// Returns a scene of blocks in rows, at a distance of each other [m].
scene::SceneSpec RowsOfBlocks(int count, int per_row, double distance) {
  scene::SceneSpec scene{.name = "rows"};
  for (int i = 0; i < count; ++i) {
    const int row = i / per_row, column = i % per_row;
    scene::ObjectSpec object;
    object.whole = {
        .id = "b" + std::to_string(i),
        .X_PE = RigidTransform(Vector3(-0.8 + distance * column, -0.4 + distance * row, 0.05)),
        .shape = scene::Block{{0.1, 0.1, 0.1}}};
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

/// Measures only the undo, of a grasp and a second of carrying.
void UndoAmongFiftyBlocks(benchmark::State& state) {
  const ScratchFolder folder;
  sim::Simulation simulation(RowsOfBlocks(50, 10, 0.16));
  recorder::Recorder recorder(folder.path() / "demo", {}, nullptr, simulation);
  simulation.AddListener(&recorder);
  for (auto _ : state) {
    simulation.Apply(sim::Grasp{.hand = HandName::kLeft, .object = "b22"});
    simulation.Apply(sim::MoveTo{.hand = HandName::kLeft, .p_WH = {0, 0, 0.3}});
    for (int i = 0; i < sim::kTicksPerSecond; ++i) simulation.Tick();
    const auto start = std::chrono::steady_clock::now();
    if (simulation.Apply(sim::Undo())) state.SkipWithError("nothing to undo");
    state.SetIterationTime(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
}

/// Returns how many bytes of the heap are in use.
double HeapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Keeps 10,000 states to which undo can go back, of a hand that does something twenty times a
/// second with one block after another, and reports the memory.
void RememberActions(benchmark::State& state) {
  constexpr int kNumActions = 10000, kNumBlocks = 100, kTicksBetween = sim::kTicksPerSecond / 20;
  for (auto _ : state) {
    sim::Simulation simulation(RowsOfBlocks(kNumBlocks, 14, 0.12));
    const double before = HeapBytes();
    for (int i = 0; i < kNumActions; ++i) {
      // Each block is lifted a little, and falls.
      if (i % 2 == 0) {
        const std::string block = "b" + std::to_string(i / 2 % kNumBlocks);
        const Vector3 p_WB =
            simulation.scene().objects[i / 2 % kNumBlocks].whole.X_PE.translation();
        simulation.Apply(sim::Grasp{.hand = HandName::kLeft, .object = block});
        simulation.Apply(sim::MoveTo{.hand = HandName::kLeft, .p_WH = p_WB + Vector3(0, 0, 0.1)});
      } else {
        simulation.Apply(sim::Release{.hand = HandName::kLeft});
      }
      for (int tick = 0; tick < kTicksBetween; ++tick) simulation.Tick();
    }
    state.counters["MB"] = (HeapBytes() - before) / 1e6;
    int steps = 0;
    while (!simulation.Apply(sim::Undo())) ++steps;
    state.counters["steps"] = steps;
  }
}

/// Measures the replay of a recording, and reports its size per hour of demonstrating.
void ReplayUm(benchmark::State& state, bool with_robot) {
  const ScratchFolder folder;
  const auto demo = folder.path() / "demo";
  sim::Simulation simulation(UmScene(), Place({.is_missing = !with_robot}));
  {
    recorder::Recorder recorder(demo, {}, nullptr, simulation);
    simulation.AddListener(&recorder);
    sim::ScriptPlayer player(
        sim::ReadScript(DataFile("examples/um.jsonl"), simulation.scene().meters_per_unit));
    for (player.Advance(&simulation); !player.is_finished(); player.Advance(&simulation)) {
      simulation.Tick();
    }
    simulation.RemoveListener(&recorder);
  }
  const recording::Recording recording = recording::OpenRecording(demo);
  for (auto _ : state) {
    if (replay::Replay(recording).first_difference) state.SkipWithError("the replay differs");
  }
  state.counters["x_real_time"] = benchmark::Counter(
      simulation.seconds() * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  ReportSize(state, demo, simulation.seconds());
}

}  // namespace

void RegisterRecordingBenchmarks() {
  using benchmark::RegisterBenchmark;
  for (const bool is_recorded : {false, true}) {
    RegisterBenchmark(is_recorded ? "moving hand, recorded, per tick" : "moving hand, per tick",
                      &TickOfAHandAtWork, is_recorded)
        ->Unit(benchmark::kMicrosecond);
  }
  RegisterBenchmark("opening of eight hours", &OpenEightHours)->Unit(benchmark::kMillisecond);
  RegisterBenchmark("undo among 50 blocks, recorded", &UndoAmongFiftyBlocks)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
  RegisterBenchmark("10,000 actions among 100 blocks", &RememberActions)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  for (const bool with_robot : {false, true}) {
    RegisterBenchmark(with_robot ? "replay of UM with robot" : "replay of UM", &ReplayUm,
                      with_robot)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace smile::bench
