#include "bench/benchmarks.h"

#include <benchmark/benchmark.h>

#include <csignal>
#include <stdexcept>
#include <vector>

#include "base/files.h"
#include "bench/internal_echo.h"
#include "bench/internal_growth.h"
#include "bench/internal_motion.h"
#include "bench/internal_parallel.h"
#include "bench/internal_physics.h"
#include "bench/internal_recording.h"
#include "bench/internal_scenes.h"
#include "brain/brain_driver.h"
#include "brain/brain_messages.h"
#include "brain/brain_process.h"
#include "catalog/robot_catalog.h"
#include "picture/rendered_eye.h"
#include "sim/simulation.h"

namespace smile::bench {
namespace {

/// Measures a physics step in which no body sleeps, without the rest of a tick.
void TwelveBlocksAwake(benchmark::State& state) {
  AwakeWorld awake(UmScene());
  awake.StepSeconds(1);
  for (auto _ : state) awake.world.Step();
  ReportRealTime(state, awake.world.config().step_seconds);
}

/// Measures a tick in which nothing happens, including the hash of the state.
void TwelveBlocksAsleep(benchmark::State& state) {
  const auto simulation = MakeUm({.is_missing = true});
  for (auto _ : state) {
    simulation->Tick();
    benchmark::DoNotOptimize(simulation->state_hash());
  }
  ReportRealTime(state, 1.0 / sim::kTicksPerSecond);
}

/// Measures a tick in which all joints of all arms move.
void TwelveBlocksAndAMovingRobot(benchmark::State& state, const BenchRobot& robot) {
  const auto simulation = MakeUm(robot);
  for (auto _ : state) {
    Swing(simulation.get());
    simulation->Tick();
  }
  ReportRealTime(state, 1.0 / sim::kTicksPerSecond);
}

/// Measures a tick in which the robot gets no commands.
void TwelveBlocksAndARestingRobot(benchmark::State& state) {
  const auto simulation = MakeUm({});
  for (auto _ : state) simulation->Tick();
  ReportRealTime(state, 1.0 / sim::kTicksPerSecond);
}

/// Carries a block of the scene `um` in front of the robot.
Carrying CarryingBlue(sim::Simulation* simulation) {
  return {simulation, "Blue1", Vector3(-0.2, -0.1, 0.3)};
}

/// Measures the copy of a state; reports the bytes of its physics.
void SnapshotSave(benchmark::State& state) {
  const auto simulation = MakeUm({});
  Carrying carrying = CarryingBlue(simulation.get());
  SaveAfterTicks(state, &carrying, simulation.get());
  state.counters["bytes"] =
      static_cast<double>(mechanics::Serialize(simulation->Save().physics).size());
}

void SnapshotRestore(benchmark::State& state) {
  const auto simulation = MakeUm({});
  Carrying carrying = CarryingBlue(simulation.get());
  RestoreOverTicks(state, &carrying, simulation.get());
}

/// Measures color, depth and ids of the view of the eye.
void EyePicture(benchmark::State& state, const BenchRobot& robot) {
  const auto simulation = MakeUm(robot);
  const sim::ViewSample sample =
      sim::ViewSampleOf(*simulation, {.width_px = static_cast<int>(state.range(0)),
                                      .height_px = static_cast<int>(state.range(1))});
  const camera::RenderOptions options{
      .depth = true, .ids = true, .excluded_frames = sample.hidden_frames};
  // The renderer and the image are reused, as in a recording.
  camera::Renderer renderer;
  Image image;
  for (auto _ : state) {
    renderer.Render(simulation->model().visual_model(), sample.state, sample.view, options, &image);
  }
  state.SetLabel(renderer.device_name());
}

/// Brain of a benchmark.
struct MeasuredBrain {
  const char* language;
  std::filesystem::path brain;
  brain::BrainTransport transport = brain::BrainTransport::kAutomatic;
};

/// Returns the same waving program in every language.
std::vector<MeasuredBrain> MeasuredBrains() {
  const std::filesystem::path octave = DataFile("matlab/examples/wave");
  return {{"Octave", octave, brain::BrainTransport::kMex},
          {"Octave without compiled client", octave, brain::BrainTransport::kPlain},
          {"Python", DataFile("python/examples/wave.py")},
          {"C++", SMILE_CPP_BRAIN}};
}

/// Questions to a brain: to start, and for one step.
struct BrainQuestions {
  brain::Aux aux;
  brain::Sensor sensor;
};

/// Returns the questions of a driver, with a picture of the size of the benchmark unless that is
/// one pixel.
BrainQuestions QuestionsOf(const benchmark::State& state, const std::filesystem::path& brain) {
  const auto simulation = MakeUm({});
  picture::RenderedEye eye({.width_px = static_cast<int>(state.range(0)),
                            .height_px = static_cast<int>(state.range(1))});
  brain::BrainDriver driver(
      {.eye = state.range(0) > 1 ? &eye : nullptr,
       .may_read = {.trackers = false, .arms = brain::WhatMayBeRead(brain).arms}});
  BrainQuestions questions{.aux =
                               std::get<brain::Aux>(driver.NextQuestion(simulation.get()).value())};
  driver.Take(brain::InitReply(), simulation.get());
  questions.sensor = std::get<brain::Sensor>(driver.NextQuestion(simulation.get()).value());
  return questions;
}

/// Measures a round trip with as many bytes as a brain receives and sends.
void BareRoundTrip(benchmark::State& state) {
  constexpr std::size_t kMotorBytes = 250;
  Echo echo(brain::EncodeSensor(1, QuestionsOf(state, "").sensor).size(), kMotorBytes);
  for (auto _ : state) echo.RoundTrip();
}

/// Measures a step of a brain: encoding, both ways through the transport, and decoding.
void BrainRoundTrip(benchmark::State& state, const MeasuredBrain& measured) {
  const BrainQuestions questions = QuestionsOf(state, measured.brain);
  brain::BrainProcess process(measured.brain, {.transport = measured.transport});
  auto reply = process.Init(questions.aux);
  if (const auto* error = std::get_if<brain::BrainError>(&reply)) {
    // A missing interpreter is not an error of the benchmark.
    state.SkipWithError(ToString(*error).c_str());
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(process.Step(questions.sensor));
}

void RegisterAll() {
  using benchmark::kMicrosecond;
  using benchmark::kMillisecond;
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("12 blocks awake, per step", &TwelveBlocksAwake)->Unit(kMicrosecond);
  RegisterBenchmark("12 blocks asleep, per tick", &TwelveBlocksAsleep)->Unit(kMicrosecond);
  for (const bool is_kinematic : {false, true}) {
    RegisterBenchmark(is_kinematic ? "12 blocks and a moving kinematic robot, per tick"
                                   : "12 blocks and a moving robot, per tick",
                      &TwelveBlocksAndAMovingRobot, BenchRobot{.is_kinematic = is_kinematic})
        ->Unit(kMicrosecond);
  }
  // The others that ship, and those that the user has added.
  for (const catalog::CatalogEntry& robot : catalog::AllRobots()) {
    if (robot.name == "baxter") continue;
    RegisterBenchmark(("12 blocks and the moving robot " + robot.name + ", per tick").c_str(),
                      &TwelveBlocksAndAMovingRobot, BenchRobot{.name = robot.name})
        ->Unit(kMicrosecond);
  }
  RegisterBenchmark("12 blocks and a resting robot, per tick", &TwelveBlocksAndARestingRobot)
      ->Unit(kMicrosecond);
  RegisterBenchmark("save after a tick, UM with robot, one block carried", &SnapshotSave)
      ->UseManualTime()
      ->Unit(kMicrosecond);
  RegisterBenchmark("restore over a tick, UM with robot, one block carried", &SnapshotRestore)
      ->UseManualTime()
      ->Unit(kMicrosecond);
  const auto pictures = [](const char* name, const BenchRobot& robot) {
    RegisterBenchmark(name, &EyePicture, robot)
        ->Args({200, 150})
        ->Args({640, 480})
        ->Args({1280, 800})
        ->MeasureProcessCPUTime()
        ->Unit(kMillisecond);
  };
  pictures("eye, UM", {.is_missing = true});
  pictures("eye, UM with robot", {});
  pictures("eye, UM with robot without grippers", {.gripper = "none"});
  RegisterPhysicsBenchmarks();
  RegisterGrowthBenchmarks();
  RegisterParallelBenchmarks();
  RegisterRecordingBenchmarks();
  RegisterMotionBenchmarks();
  // A picture of 1 x 1 px stands for no picture. Real time, as the work is done in another process.
  const auto with_pictures = [](benchmark::internal::Benchmark* round_trip) {
    round_trip->Args({1, 1})->Args({200, 150})->Args({640, 480})->UseRealTime()->Unit(kMicrosecond);
  };
  RegisterBenchmark("brain round trip, bare socket", &BareRoundTrip)->Apply(with_pictures);
  for (const MeasuredBrain& measured : MeasuredBrains()) {
    const std::string name = std::string("brain round trip, ") + measured.language;
    RegisterBenchmark(name.c_str(), &BrainRoundTrip, measured)->Apply(with_pictures);
  }
}

}  // namespace

void RunBenchmarks(const BenchOptions& options) {
  // The benchmark library reads its options from a command line only.
  std::vector<std::string> words{"smile bench"};
  if (!options.filter.empty()) words.push_back("--benchmark_filter=" + options.filter);
  if (options.json) words.emplace_back("--benchmark_format=json");
  if (options.min_time)
    words.push_back("--benchmark_min_time=" + std::to_string(*options.min_time));
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  int count = static_cast<int>(arguments.size());
  // There is nothing to keep, so Ctrl-C simply ends the program.
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  RegisterAll();
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::RunSpecifiedBenchmarks() > 0) return;
  throw std::invalid_argument("no benchmark is called like '" + options.filter + "'");
}

}  // namespace smile::bench
