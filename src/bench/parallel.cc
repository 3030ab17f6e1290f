// Several simulations in one process share nothing that changes, so two threads should do twice the
// work of one. Each iteration does the same work on one thread and then on two, so that both see
// the same machine.

#include "bench/internal_parallel.h"

#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "bench/internal_scenes.h"

namespace smile::bench {
namespace {

/// What one thread does.
using Work = std::function<void()>;

struct Workload {
  const char* name;
  /// Returns the work of two threads, on two worlds.
  std::pair<Work, Work> (*make)();
};

/// Advances the scene `um` by six seconds, with a robot that swings its arms, and hashes each tick
/// as a recording does. Both simulations have the same model and begin with the same state.
std::pair<Work, Work> SwingingRobots() {
  const auto first = std::shared_ptr<sim::Simulation>(MakeUm({}));
  const auto second = std::make_shared<sim::Simulation>(first->shared_model());
  second->Restore(first->Save());
  const auto work = [](const std::shared_ptr<sim::Simulation>& simulation) {
    return [simulation] {
      for (int i = 0; i < 6 * sim::kTicksPerSecond; ++i) {
        Swing(simulation.get());
        simulation->Tick();
        benchmark::DoNotOptimize(simulation->state_hash());
      }
    };
  };
  return {work(first), work(second)};
}

/// Advances ten stacks of five cubes that never sleep by one and a half seconds.
std::pair<Work, Work> StacksThatNeverSleep() {
  const auto work = [] {
    return [awake = std::make_shared<AwakeWorld>(Stacks(50, 5, 0.1, 0.1))] {
      for (int i = 0; i < 720; ++i) awake->world.Step();
    };
  };
  return {work(), work()};
}

/// Makes, saves and restores simulations of the same model of 50 cubes: mostly memory, much of it
/// shared.
std::pair<Work, Work> SavesAndRestores() {
  const Work work = [model = std::make_shared<const model::Model>(Stacks(50, 1, 0.05, 0.03))] {
    sim::Simulation simulation(model);
    for (int i = 0; i < 200; ++i) {
      simulation.Tick();
      simulation.Restore(simulation.Save());
    }
  };
  return {work, work};
}

/// Computes in registers only: two threads share neither memory nor caches, so what they lose is
/// the machine's.
std::pair<Work, Work> ArithmeticOnly() {
  const auto work = [] {
    double x = 0.5;
    for (int i = 0; i < 12'000'000; ++i) x = 3.9 * x * (1 - x);
    benchmark::DoNotOptimize(x);
  };
  return {work, work};
}

constexpr Workload kWorkloads[] = {{"arithmetic only", &ArithmeticOnly},
                                   {"UM with a moving robot", &SwingingRobots},
                                   {"10 stacks of 5 awake", &StacksThatNeverSleep},
                                   {"saves and restores", &SavesAndRestores}};

double CpuSeconds(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Cost {
  double wall = 0;  ///< [s]
  double cpu = 0;   ///< of all threads [s]
};

Cost CostOf(const std::function<void()>& run) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu_start = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
  run();
  return {.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          .cpu = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_start};
}

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Measures two simulations on two threads. Reports how many times as fast they are as one after
/// the other on one thread: by the shortest times of all iterations, which other programs and
/// machines disturbed least, and by CPU time, as the median over the iterations, each of which
/// compares two adjacent runs.
void TwoOnTwoThreads(benchmark::State& state, const Workload& workload) {
  const auto works = workload.make();
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double shortest_on_one = kNone, shortest_on_two = kNone;  // [s]
  std::vector<double> speed_ups_by_cpu_time;
  for (auto _ : state) {
    const Cost one_thread = CostOf([&] {
      works.first();
      works.second();
    });
    const Cost two_threads = CostOf([&] {
      std::thread other(works.second);
      works.first();
      other.join();
    });
    shortest_on_one = std::min(shortest_on_one, one_thread.wall);
    shortest_on_two = std::min(shortest_on_two, two_threads.wall);
    speed_ups_by_cpu_time.push_back(2 * one_thread.cpu / two_threads.cpu);
    state.SetIterationTime(two_threads.wall);
  }
  state.counters["speed_up"] = shortest_on_one / shortest_on_two;
  state.counters["speed_up_by_cpu_time"] = MedianOf(std::move(speed_ups_by_cpu_time));
}

}  // namespace

void RegisterParallelBenchmarks() {
  for (const Workload& workload : kWorkloads) {
    const std::string name = std::string("parallel: two on two threads, ") + workload.name;
    benchmark::RegisterBenchmark(name.c_str(), &TwoOnTwoThreads, workload)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace smile::bench
