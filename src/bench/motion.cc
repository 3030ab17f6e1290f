#include "bench/internal_motion.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "base/files.h"
#include "motion/arm_moves.h"
#include "motion/inverse_kinematics.h"
#include "motion/path_check.h"
#include "robot/urdf_reader.h"

namespace smile::bench {
namespace {

using motion::ArmKinematics;

constexpr int kNumPoses = 10'000;

robot::RobotModel Baxter() { return robot::ReadRobot(DataFile("robots/baxter.urdf")); }

/// Returns random configurations within the joint limits; the same ones in every run.
std::vector<std::vector<double>> RandomConfigurations(const ArmKinematics& arm) {
  std::mt19937_64 random(1);
  std::vector<std::vector<double>> configurations(kNumPoses);
  for (std::vector<double>& q : configurations) {
    for (const motion::JointLimits& limit : arm.limits()) {
      q.push_back(std::uniform_real_distribution<double>(limit.lower, limit.upper)(random));
    }
  }
  return configurations;
}

/// Returns the initial configuration of an arm.
std::vector<double> StartOf(const robot::RobotModel& model, const robot::Arm& arm) {
  std::vector<double> q;
  for (const int joint : arm.joints) q.push_back(model.q_start[joint]);
  return q;
}

void ForwardKinematics(benchmark::State& state) {
  const robot::RobotModel model = Baxter();
  const ArmKinematics arm(model, model.arms.front());
  const auto configurations = RandomConfigurations(arm);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(arm.ToolPose(configurations[i++ % configurations.size()]));
  }
}

/// One iteration solves for all poses, each from the robot's initial posture.
void InverseKinematics(benchmark::State& state, bool any_turn) {
  const robot::RobotModel model = Baxter();
  const ArmKinematics arm(model, model.arms.front());
  const std::vector<double> q_start = StartOf(model, model.arms.front());
  std::vector<RigidTransform> goals;
  for (const auto& q : RandomConfigurations(arm)) goals.push_back(arm.ToolPose(q));
  int num_found = 0;
  std::vector<double> microseconds;
  for (auto _ : state) {
    num_found = 0;
    microseconds.clear();
    for (const RigidTransform& goal : goals) {
      const auto start = std::chrono::steady_clock::now();
      if (SolveInverseKinematics(arm, goal, q_start, {.any_turn = any_turn})) ++num_found;
      const std::chrono::duration<double, std::micro> taken =
          std::chrono::steady_clock::now() - start;
      microseconds.push_back(taken.count());
    }
  }
  std::ranges::sort(microseconds);
  state.counters["success"] = static_cast<double>(num_found) / kNumPoses;
  state.counters["median_us"] = microseconds[kNumPoses / 2];
  state.counters["p99_us"] = microseconds[kNumPoses * 99 / 100];
}

/// Plans a motion of 0.3 m down to the table.
void LineOfTheTool(benchmark::State& state) {
  const robot::RobotModel model = Baxter();
  const ArmKinematics arm(model, model.arms.front());
  const RigidTransform down(Quaternion(0, 1, 0, 0), Vector3(0.65, 0.3, 0.25));
  const auto q = SolveInverseKinematics(arm, down, StartOf(model, model.arms.front()));
  const RigidTransform goal(down.rotation(), down.translation() - Vector3(0, 0, 0.3));
  if (!q || std::holds_alternative<motion::LineFault>(MoveAlongLine(arm, *q, goal))) {
    state.SkipWithError("the arm cannot reach the goal");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(MoveAlongLine(arm, *q, goal));
}

/// Measures the test of a configuration for contact between links, while one arm moves as a whole.
void SelfCollisionCheck(benchmark::State& state) {
  const robot::RobotModel model = Baxter();
  motion::ArticulationProbe probe(robot::MakeArticulationSpec(model, {}));
  std::vector<double> q = model.q_start;
  double step = 0.01;
  for (auto _ : state) {
    q[model.arms[0].joints.front()] += step;
    step = -step;
    benchmark::DoNotOptimize(probe.FirstOverlap(q));
  }
}

}  // namespace

void RegisterMotionBenchmarks() {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("forward kinematics, one arm", &ForwardKinematics)
      ->Unit(benchmark::kMicrosecond);
  for (const bool any_turn : {false, true}) {
    RegisterBenchmark(any_turn ? "inverse kinematics, one arm, any rotation, 10000 poses"
                               : "inverse kinematics, one arm, 10000 poses",
                      &InverseKinematics, any_turn)
        ->Unit(benchmark::kMillisecond);
  }
  RegisterBenchmark("straight tool motion, 0.3 m", &LineOfTheTool)->Unit(benchmark::kMicrosecond);
  RegisterBenchmark("self-collision check", &SelfCollisionCheck)->Unit(benchmark::kMicrosecond);
}

}  // namespace smile::bench
