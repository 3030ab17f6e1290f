// Speed alone says little about physics, since a solver can be fast and wrong. So a minute of some
// scenes is measured with what it is worth: how deep objects sink and how far they creep while none
// of them may sleep, and how well a robot follows. tools/measure_performance.py simulates the same
// scenes in other simulators.

#include "bench/internal_physics.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/internal_scenes.h"

namespace smile::bench {
namespace {

constexpr int kSettlingSeconds = 3;
constexpr int kMinute = 60;  ///< [s]

/// Edge of the cubes in stacks, and the gap between the stacks [m].
constexpr double kStackEdge = 0.1, kStackGap = 0.1;

struct AwakeScene {
  const char* name;
  scene::SceneSpec (*make)();
};

constexpr AwakeScene kScenes[] = {
    {"UM", &UmScene},
    {"10 stacks of 5", [] { return Stacks(50, 5, kStackEdge, kStackGap); }},
    {"5 stacks of 10", [] { return Stacks(50, 10, kStackEdge, kStackGap); }},
};

using Positions = std::vector<Vector3>;

Positions PositionsOf(const physics::World& world, const world::Tabletop& tabletop) {
  Positions positions;
  for (const auto& object : tabletop.objects())
    positions.push_back(world.body(object.body).pose_in_world().translation());
  return positions;
}

/// Reports the deepest that an object lies below its place in the scene when all have settled, and
/// the farthest that one has moved at the end.
void ReportSagAndCreep(benchmark::State& state, const Positions& placed, const Positions& settled,
                       const Positions& end) {
  double sag = 0, creep = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    sag = std::max(sag, placed[i].z() - settled[i].z());
    creep = std::max(creep, (end[i] - settled[i]).norm());
  }
  state.counters["sag_mm"] = 1000 * sag;
  state.counters["creep_mm"] = 1000 * creep;
}

/// Measures a physics step.
void StepAwake(benchmark::State& state, const AwakeScene& scene) {
  AwakeWorld awake(scene.make());
  awake.StepSeconds(1);
  for (auto _ : state) awake.world.Step();
  ReportRealTime(state, awake.world.config().step_seconds);
}

/// Measures a simulated minute after the scene has settled.
void MinuteAwake(benchmark::State& state, const AwakeScene& scene) {
  AwakeWorld awake(scene.make());
  const Positions placed = PositionsOf(awake.world, awake.tabletop);
  awake.StepSeconds(kSettlingSeconds);
  const Positions settled = PositionsOf(awake.world, awake.tabletop);
  for (auto _ : state) awake.StepSeconds(kMinute);
  ReportSagAndCreep(state, placed, settled, PositionsOf(awake.world, awake.tabletop));
  ReportRealTime(state, kMinute);
}

/// Measures a simulated minute in which all blocks of `um` sleep.
void MinuteAsleep(benchmark::State& state) {
  const auto simulation = MakeUm({.is_missing = true});
  const Positions settled = PositionsOf(simulation->physics(), simulation->tabletop());
  Positions placed;
  for (const auto& object : simulation->scene().objects)
    placed.push_back(object.pose_in_world().translation());
  for (auto _ : state) {
    for (int tick = 0; tick < kMinute * sim::kTicksPerSecond; ++tick) simulation->Tick();
  }
  ReportSagAndCreep(state, placed, settled,
                    PositionsOf(simulation->physics(), simulation->tabletop()));
  ReportRealTime(state, kMinute);
}

/// Measures a simulated minute of a robot without grippers that swings its arms while the blocks of
/// `um` sleep. Reports by how much a joint of the arms ever misses its place at the end of a swing.
void MinuteOfSwinging(benchmark::State& state) {
  const auto simulation = MakeUm({.gripper = "none"});
  const robot::RobotModel& robot = simulation->robot()->model();
  const std::vector<double> q_first = simulation->robot()->positions();
  double error = 0;
  for (auto _ : state) {
    for (int tick = 0; tick < kMinute * sim::kTicksPerSecond; ++tick) {
      Swing(simulation.get());
      simulation->Tick();
      if ((tick + 1) % kSwingTicks != 0) continue;
      const double wanted = (tick + 1) / kSwingTicks % 2 == 0 ? 0 : kSwingAngle;
      const std::vector<double> q = simulation->robot()->positions();
      for (const robot::Arm& arm : robot.arms) {
        for (const int joint : arm.joints) {
          // A joint that begins at its limit cannot follow.
          if (q_first[joint] + kSwingAngle >= robot.links[joint].upper) continue;
          error = std::max(error, std::abs(q[joint] - q_first[joint] - wanted));
        }
      }
    }
  }
  state.counters["joint_error_rad"] = error;
  ReportRealTime(state, kMinute);
}

/// Measures the first second in which twenty rings fall on a heap.
void FirstSecondOfAHeap(benchmark::State& state) {
  AwakeWorld awake(FallingRings(20, static_cast<int>(state.range(0))));
  for (auto _ : state) awake.StepSeconds(1);
  ReportRealTime(state, 1);
}

}  // namespace

void RegisterPhysicsBenchmarks() {
  using benchmark::RegisterBenchmark;
  for (const AwakeScene& scene : kScenes) {
    const std::string name = std::string("awake: ") + scene.name;
    RegisterBenchmark((name + ", per step").c_str(), &StepAwake, scene)
        ->Unit(benchmark::kMicrosecond);
    RegisterBenchmark((name + ", a minute").c_str(), &MinuteAwake, scene)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  RegisterBenchmark("UM asleep, a minute", &MinuteAsleep)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  RegisterBenchmark("UM and a moving robot without grippers, a minute", &MinuteOfSwinging)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  RegisterBenchmark("awake: 20 rings, per step", &StepAwake,
                    AwakeScene{"20 rings", [] { return Rings(20); }})
      ->Unit(benchmark::kMicrosecond);
  RegisterBenchmark("awake: 20 rings fall on a heap, the first second", &FirstSecondOfAHeap)
      ->ArgName("sides")
      ->Arg(32)
      ->Arg(64)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace smile::bench
