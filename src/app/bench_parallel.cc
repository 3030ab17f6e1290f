// Several simulations in one process share nothing that changes, so two threads should do twice the
// work of one. Each iteration does the same work on one thread and then on two, so that both see
// the same machine.

#include "app/bench_parallel.h"

#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "app/bench_scenes.h"

namespace smile::app {
namespace {

/// What one thread does.
using Work = std::function<void()>;

struct Workload {
  const char* name;
  /// Returns the work of two threads, on two worlds.
  std::pair<Work, Work> (*make)();
};

/// Advances the scene `um` by two seconds, with a robot that swings its arms, and hashes each tick
/// as a recording does. Both simulations have the same model and begin with the same state.
std::pair<Work, Work> SwingingRobots() {
  const auto first = std::shared_ptr<sim::Simulation>(MakeUm({}));
  const auto second = std::make_shared<sim::Simulation>(first->shared_model());
  second->Restore(first->Save());
  const auto work = [](const std::shared_ptr<sim::Simulation>& simulation) {
    return [simulation] {
      for (int i = 0; i < 2 * sim::kTicksPerSecond; ++i) {
        Swing(simulation.get());
        simulation->Tick();
        benchmark::DoNotOptimize(simulation->state_hash());
      }
    };
  };
  return {work(first), work(second)};
}

/// Advances ten stacks of five cubes that never sleep by half a second.
std::pair<Work, Work> StacksThatNeverSleep() {
  const auto work = [] {
    return [awake = std::make_shared<AwakeWorld>(Stacks(50, 5, 0.1, 0.1))] {
      for (int i = 0; i < 240; ++i) awake->world.Step();
    };
  };
  return {work(), work()};
}

/// Makes, saves and restores simulations of the same model of 50 cubes: mostly memory, much of it
/// shared.
std::pair<Work, Work> SavesAndRestores() {
  const Work work = [model = std::make_shared<const model::Model>(Stacks(50, 1, 0.05, 0.03))] {
    sim::Simulation simulation(model);
    for (int i = 0; i < 100; ++i) {
      simulation.Tick();
      simulation.Restore(simulation.Save());
    }
  };
  return {work, work};
}

constexpr Workload kWorkloads[] = {{"UM with a moving robot", &SwingingRobots},
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
/// the other on one thread, and the same by CPU time: twice the CPU time on one thread by that on
/// two. Both are medians over the iterations, of which each compares two adjacent runs: the speed
/// of the processor changes from one iteration to another.
void TwoOnTwoThreads(benchmark::State& state, const Workload& workload) {
  const auto works = workload.make();
  std::vector<double> speed_ups, speed_ups_by_cpu_time;
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
    speed_ups.push_back(one_thread.wall / two_threads.wall);
    speed_ups_by_cpu_time.push_back(2 * one_thread.cpu / two_threads.cpu);
    state.SetIterationTime(two_threads.wall);
  }
  state.counters["speed_up"] = MedianOf(std::move(speed_ups));
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

}  // namespace smile::app
