// How the cost of a tick, of a hash and of a saved state grows with the number of objects of which
// none, one or all move.

#include "app/bench_growth.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string>

#include "sim/simulation.h"

namespace smile::app {
namespace {

/// Edge of each cube [m].
constexpr double kEdge = 0.05;

/// Returns stacks of cubes on a square grid that the table just holds.
/// @param gap  between neighboring stacks [m]
scene::SceneSpec Stacks(int num_cubes, int cubes_a_stack, double gap) {
  const int num_stacks = (num_cubes + cubes_a_stack - 1) / cubes_a_stack;
  const int num_columns = static_cast<int>(std::ceil(std::sqrt(num_stacks)));
  const double spacing = kEdge + gap, span = num_columns * spacing + 0.2;
  scene::SceneSpec scene{.name = "stacks", .table = {.x_span = span, .y_span = span}};
  for (int i = 0; i < num_cubes; ++i) {
    const int stack = i / cubes_a_stack, level = i % cubes_a_stack;
    const int row = stack / num_columns, column = stack % num_columns;
    const double x = (column - 0.5 * (num_columns - 1)) * spacing;
    const double y = (row - 0.5 * (num_columns - 1)) * spacing;
    scene::ObjectSpec cube;
    cube.whole = {.id = "cube" + std::to_string(i),
                  .X_PE = RigidTransform(Vector3(x, y, (level + 0.5) * kEdge)),
                  .shape = scene::Block{{kEdge, kEdge, kEdge}}};
    scene.objects.push_back(std::move(cube));
  }
  return scene;
}

/// Returns a simulation of cubes that have had three seconds to come to rest.
std::unique_ptr<sim::Simulation> Rested(const benchmark::State& state) {
  const double gap = 0.001 * static_cast<double>(state.range(1));
  auto simulation =
      std::make_unique<sim::Simulation>(Stacks(static_cast<int>(state.range(0)), 1, gap));
  for (int i = 0; i < 3 * sim::kTicksPerSecond; ++i) simulation->Tick();
  return simulation;
}

/// Carries the first cube to and fro above the others, after it was lifted for a second.
void CarryOn(sim::Simulation* simulation, std::uint64_t since) {
  const std::uint64_t ticks = simulation->tick() - since;
  if (ticks % sim::kTicksPerSecond != 0) return;
  Vector3 p_WH = simulation->scene().objects.front().pose_in_world().translation();
  if (ticks == 0) {
    simulation->Apply(sim::Grasp{.object = "cube0"});
  } else {
    p_WH.x() += ticks / sim::kTicksPerSecond % 2 == 0 ? 0.0 : 0.4;
  }
  p_WH.z() = 0.4;
  simulation->Apply(sim::MoveTo{.p_WH = p_WH, .speed = 0.4});
}

/// Measures a tick while a hand carries one cube, with the hash of the state as in a recording or
/// without it.
void CarryOne(benchmark::State& state, bool with_hash) {
  const auto simulation = Rested(state);
  const std::uint64_t since = simulation->tick();
  // First those that it disturbed come to rest again.
  for (int i = 0; i < 5 * sim::kTicksPerSecond; ++i) {
    CarryOn(simulation.get(), since);
    simulation->Tick();
  }
  for (auto _ : state) {
    CarryOn(simulation.get(), since);
    simulation->Tick();
    if (with_hash) benchmark::DoNotOptimize(simulation->state_hash());
  }
  state.counters["awake"] = static_cast<double>(simulation->physics().awake_bodies().size());
}

void TickAsleep(benchmark::State& state) {
  const auto simulation = Rested(state);
  for (auto _ : state) simulation->Tick();
}

void Hash(benchmark::State& state) {
  const auto simulation = Rested(state);
  for (auto _ : state) benchmark::DoNotOptimize(simulation->state_hash());
}

void Save(benchmark::State& state) {
  const auto simulation = Rested(state);
  for (auto _ : state) benchmark::DoNotOptimize(simulation->Save());
}

/// Measures a physics step of stacks of five that never sleep.
void StacksAwake(benchmark::State& state) {
  physics::World world({.sleep_linear_speed = 0, .sleep_angular_speed = 0});
  const double gap = 0.001 * static_cast<double>(state.range(1));
  const world::Tabletop tabletop(&world, Stacks(static_cast<int>(state.range(0)), 5, gap));
  for (int i = 0; i < 480; ++i) world.Step();
  for (auto _ : state) world.Step();
}

}  // namespace

void RegisterGrowthBenchmarks() {
  const auto cubes_and_gaps = [](benchmark::internal::Benchmark* row) {
    row->ArgNames({"cubes", "gap_mm"})
        ->ArgsProduct({{12, 100, 1000}, {70, 30}})
        ->Unit(benchmark::kMicrosecond);
  };
  using benchmark::RegisterBenchmark;
  for (const bool with_hash : {false, true}) {
    RegisterBenchmark(with_hash ? "growth: one cube carried, the others asleep, per tick and hash"
                                : "growth: one cube carried, the others asleep, per tick",
                      &CarryOne, with_hash)
        ->Apply(cubes_and_gaps);
  }
  RegisterBenchmark("growth: all asleep, per tick", &TickAsleep)->Apply(cubes_and_gaps);
  RegisterBenchmark("growth: hash, all asleep", &Hash)->Apply(cubes_and_gaps);
  RegisterBenchmark("growth: save, all asleep", &Save)->Apply(cubes_and_gaps);
  RegisterBenchmark("growth: stacks of five awake, per step", &StacksAwake)->Apply(cubes_and_gaps);
}

}  // namespace smile::app
