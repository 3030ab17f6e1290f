// Scenes in which no object sleeps. Speed alone says little about physics, since a solver can be
// fast and wrong: of scenes that stand still, a minute is therefore measured, too, with how deep
// its objects sink and how far they creep. tools/performance.py measures the same scenes in other
// simulators.

#include "app/bench_awake.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "app/bench_scenes.h"

namespace smile::app {
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

std::vector<Vector3> PositionsOf(const AwakeWorld& awake) {
  std::vector<Vector3> positions;
  for (const auto& object : awake.tabletop.objects())
    positions.push_back(awake.world.body(object.body).pose_in_world().translation());
  return positions;
}

/// Measures a physics step.
void StepAwake(benchmark::State& state, const AwakeScene& scene) {
  AwakeWorld awake(scene.make());
  awake.StepSeconds(1);
  for (auto _ : state) awake.world.Step();
  ReportRealTime(state, awake.world.config().step_seconds);
}

/// Measures a simulated minute after the scene has settled. Reports the deepest that an object then
/// lies below its place in the scene (sag), and the farthest that one moves in the minute (creep).
void MinuteAwake(benchmark::State& state, const AwakeScene& scene) {
  AwakeWorld awake(scene.make());
  const std::vector<Vector3> placed = PositionsOf(awake);
  awake.StepSeconds(kSettlingSeconds);
  const std::vector<Vector3> settled = PositionsOf(awake);
  for (auto _ : state) awake.StepSeconds(kMinute);
  const std::vector<Vector3> final = PositionsOf(awake);
  double sag = 0, creep = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    sag = std::max(sag, placed[i].z() - settled[i].z());
    creep = std::max(creep, (final[i] - settled[i]).norm());
  }
  state.counters["sag_mm"] = 1000 * sag;
  state.counters["creep_mm"] = 1000 * creep;
  ReportRealTime(state, kMinute);
}

}  // namespace

void RegisterAwakeBenchmarks() {
  using benchmark::RegisterBenchmark;
  for (const AwakeScene& scene : kScenes) {
    const std::string name = std::string("awake: ") + scene.name;
    RegisterBenchmark((name + ", per step").c_str(), &StepAwake, scene)
        ->Unit(benchmark::kMicrosecond);
    RegisterBenchmark((name + ", a minute").c_str(), &MinuteAwake, scene)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  RegisterBenchmark("awake: 20 rings, per step", &StepAwake,
                    AwakeScene{"20 rings", [] { return Rings(20); }})
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace smile::app
