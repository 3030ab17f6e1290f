// How the cost of what a program does in each tick grows with the number of objects of which none,
// one or all move.

#include "bench/internal_growth.h"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bench/internal_scenes.h"
#include "sim/simulation.h"

namespace smile::bench {
namespace {

/// Edge of each cube [m].
constexpr double kEdge = 0.05;

scene::SceneSpec CubesOf(const benchmark::State& state, int cubes_a_stack) {
  return Stacks(static_cast<int>(state.range(0)), cubes_a_stack, kEdge,
                0.001 * static_cast<double>(state.range(1)));
}

/// What stands on the table around the first cube.
enum class Others { kCubes, kLidBoxes, kFixtures };

/// Returns a cube on a square grid of cubes, of boxes with sliding lids, or of static cubes.
scene::SceneSpec SceneOf(const benchmark::State& state, Others others) {
  scene::SceneSpec scene = CubesOf(state, 1);
  const std::vector<scene::ObjectSpec> cubes = std::move(scene.objects);
  scene.objects = {cubes.front()};
  for (std::size_t i = 1; i < cubes.size(); ++i) {
    scene.objects.push_back(cubes[i]);
    if (others == Others::kFixtures) scene.objects.back().mass = 0;
    if (others != Others::kLidBoxes) continue;
    scene::ObjectSpec lid = cubes[i];
    lid.whole.id = "lid" + std::to_string(i);
    lid.whole.shape = scene::Block{{kEdge, kEdge, 0.2 * kEdge}};
    const RigidTransform X_WJ(cubes[i].pose_in_world().translation() + Vector3(0, 0, 0.6 * kEdge));
    lid.whole.X_PE = X_WJ;
    scene.sliders.push_back({.X_WJ = X_WJ,
                             .X_JA = X_WJ.inverse() * cubes[i].pose_in_world(),
                             .first_object = scene.objects.size() - 1,
                             .max_offset = 0.8 * kEdge,
                             .damping = 0.5});
    scene.objects.push_back(std::move(lid));
  }
  return scene;
}

/// Returns a simulation of objects that have had three seconds to come to rest.
std::unique_ptr<sim::Simulation> Rested(const benchmark::State& state,
                                        Others others = Others::kCubes) {
  // A thousand cubes take seconds to come to rest, and the library runs each benchmark several
  // times.
  static std::map<std::tuple<Others, int64_t, int64_t>, sim::SimulationState> rested;
  auto simulation = std::make_unique<sim::Simulation>(SceneOf(state, others));
  const std::tuple key(others, state.range(0), state.range(1));
  if (const auto found = rested.find(key); found != rested.end()) {
    simulation->Restore(found->second);
  } else {
    for (int i = 0; i < 3 * sim::kTicksPerSecond; ++i) simulation->Tick();
    rested.emplace(key, simulation->Save());
  }
  return simulation;
}

/// Returns a hand that carries the first cube above the others.
Carrying CarryingOneOf(sim::Simulation* simulation) {
  Vector3 p_WH = simulation->scene().objects.front().pose_in_world().translation();
  p_WH.z() = 0.4;
  return {simulation, "cube0", p_WH};
}

/// What a program asks after each tick.
enum class Questions { kNone, kHash, kRestAndView };

/// Measures a tick while a hand carries one cube: alone, with the hash of the state as in a
/// recording, or with the questions of a view.
void CarryOne(benchmark::State& state, Questions questions) {
  const auto simulation = Rested(state);
  Carrying carrying = CarryingOneOf(simulation.get());
  for (auto _ : state) {
    carrying.Tick();
    if (questions == Questions::kHash) benchmark::DoNotOptimize(simulation->state_hash());
    if (questions == Questions::kRestAndView) {
      benchmark::DoNotOptimize(simulation->is_still());
      benchmark::DoNotOptimize(simulation->visual_state().poses.data());
    }
  }
  state.counters["awake"] = static_cast<double>(simulation->physics().awake_bodies().size());
}

/// Measures a tick while a hand carries a cube among others that sleep or never move.
void CarryAmong(benchmark::State& state, Others others) {
  const auto simulation = Rested(state, others);
  Carrying carrying = CarryingOneOf(simulation.get());
  for (auto _ : state) carrying.Tick();
}

/// Measures what an undo costs a program that keeps no recording: a grasp, three ticks, and the way
/// back.
void GraspAndUndo(benchmark::State& state) {
  const auto simulation = Rested(state);
  // The others fell asleep in the same step as all; what sleeps for longer is left out.
  simulation->Apply(sim::Grasp{.object = "cube0"});
  for (int i = 0; i < sim::kTicksPerSecond; ++i) simulation->Tick();
  simulation->Apply(sim::Release{});
  for (int i = 0; i < 3 * sim::kTicksPerSecond; ++i) simulation->Tick();
  for (auto _ : state) {
    simulation->Apply(sim::Grasp{.object = "cube0"});
    for (int i = 0; i < 3; ++i) simulation->Tick();
    simulation->Apply(sim::Undo{});
  }
}

void TickAsleep(benchmark::State& state) {
  const auto simulation = Rested(state);
  for (auto _ : state) simulation->Tick();
}

void Hash(benchmark::State& state) {
  const auto simulation = Rested(state);
  for (auto _ : state) benchmark::DoNotOptimize(simulation->state_hash());
}

void IsStill(benchmark::State& state) {
  const auto simulation = Rested(state);
  for (auto _ : state) benchmark::DoNotOptimize(simulation->is_still());
}

void VisualState(benchmark::State& state) {
  const auto simulation = Rested(state);
  for (auto _ : state) benchmark::DoNotOptimize(simulation->visual_state().poses.data());
}

void Save(benchmark::State& state) {
  const auto simulation = Rested(state);
  Carrying carrying = CarryingOneOf(simulation.get());
  SaveAfterTicks(state, &carrying, simulation.get());
}

void Restore(benchmark::State& state) {
  const auto simulation = Rested(state);
  Carrying carrying = CarryingOneOf(simulation.get());
  RestoreOverTicks(state, &carrying, simulation.get());
}

/// Measures a physics step of stacks that never sleep.
void StacksAwake(benchmark::State& state, int cubes_a_stack) {
  AwakeWorld awake(CubesOf(state, cubes_a_stack));
  awake.StepSeconds(1);
  for (auto _ : state) awake.world.Step();
  ReportRealTime(state, awake.world.config().step_seconds);
}

}  // namespace

void RegisterGrowthBenchmarks() {
  using benchmark::RegisterBenchmark;
  const auto cubes = [](benchmark::internal::Benchmark* row) {
    row->ArgNames({"cubes", "gap_mm"})
        ->ArgsProduct({{12, 50, 100, 200, 1000}, {30}})
        ->Unit(benchmark::kMicrosecond);
  };
  RegisterBenchmark("growth: one cube carried, the others asleep, per tick", &CarryOne,
                    Questions::kNone)
      ->Apply(cubes);
  RegisterBenchmark("growth: one cube carried, the others asleep, per tick and hash", &CarryOne,
                    Questions::kHash)
      ->Apply(cubes);
  RegisterBenchmark("growth: one cube carried, the others asleep, per tick, rest test and view",
                    &CarryOne, Questions::kRestAndView)
      ->Apply(cubes);
  const auto some = [](benchmark::internal::Benchmark* row) {
    row->ArgNames({"cubes", "gap_mm"})
        ->ArgsProduct({{12, 100, 400}, {30}})
        ->Unit(benchmark::kMicrosecond);
  };
  RegisterBenchmark("growth: one cube carried among boxes with lids asleep, per tick", &CarryAmong,
                    Others::kLidBoxes)
      ->Apply(some);
  RegisterBenchmark("growth: one cube carried among fixtures, per tick", &CarryAmong,
                    Others::kFixtures)
      ->Apply(some);
  RegisterBenchmark("growth: grasp, three ticks and undo", &GraspAndUndo)->Apply(some);
  RegisterBenchmark("growth: all asleep, per tick", &TickAsleep)->Apply(cubes);
  RegisterBenchmark("growth: hash, all asleep", &Hash)->Apply(cubes);
  RegisterBenchmark("growth: rest test, all asleep", &IsStill)->Apply(cubes);
  RegisterBenchmark("growth: view, all asleep", &VisualState)->Apply(cubes);
  RegisterBenchmark("growth: save after a tick, one cube carried", &Save)
      ->Apply(cubes)
      ->UseManualTime();
  RegisterBenchmark("growth: restore over a tick, one cube carried", &Restore)
      ->Apply(cubes)
      ->UseManualTime();
  RegisterBenchmark("growth: single cubes awake, per step", &StacksAwake, 1)->Apply(cubes);
  RegisterBenchmark("growth: stacks of five awake, per step", &StacksAwake, 5)->Apply(cubes);
}

}  // namespace smile::bench
