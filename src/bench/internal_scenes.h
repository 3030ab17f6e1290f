#pragma once

#include <benchmark/benchmark.h>

#include <memory>
#include <optional>
#include <string>

#include "physics/world.h"
#include "scene/scene_spec.h"
#include "sim/simulation.h"
#include "world/tabletop.h"

namespace smile::bench {

// Scenes that several benchmarks measure.

/// Robot of a benchmark.
struct BenchRobot {
  bool is_missing = false;
  std::string name = "baxter", gripper = {};  ///< empty gripper: the default of the robot
  bool is_kinematic = false;
};

/// Returns the robot with its placement; nullopt if it is missing.
std::optional<sim::RobotPlacement> Place(const BenchRobot& robot);

/// Returns the scene `um`: ten blocks and two planks.
scene::SceneSpec UmScene();
/// Returns a simulation of the scene `um` that has had three simulated seconds to come to rest.
std::unique_ptr<sim::Simulation> MakeUm(const BenchRobot& robot);

/// Duration of a swing, and how far it turns each joint [rad].
inline constexpr int kSwingTicks = sim::kTicksPerSecond / 2;
inline constexpr double kSwingAngle = 0.15;
/// Swings all arms of the robot to and fro. Call before each tick; begins at a multiple of
/// 2 * kSwingTicks.
void Swing(sim::Simulation* simulation);

/// A hand that carries an object of a simulation at rest to and fro above the others.
class Carrying {
 public:
  /// Takes the object, and carries it until those that it disturbed have come to rest again.
  /// @param p_WFrom  one end of the way of the hand [m]; the other is 0.4 m from it along the x
  /// axis.
  Carrying(sim::Simulation* simulation, const std::string& object, const Vector3& p_WFrom);
  void Tick();

 private:
  sim::Simulation* simulation_;
  Vector3 p_WFrom_;
  std::uint64_t num_ticks_ = 0;
};

/// Measures a save after each tick, for UseManualTime().
void SaveAfterTicks(benchmark::State& state, Carrying* carrying, sim::Simulation* simulation);
/// Measures the way back over a tick, for UseManualTime().
void RestoreOverTicks(benchmark::State& state, Carrying* carrying, sim::Simulation* simulation);

/// Returns stacks of cubes on a square grid that the table just holds.
/// @param edge  of each cube [m]
/// @param gap   between neighboring stacks [m]
scene::SceneSpec Stacks(int num_cubes, int cubes_a_stack, double edge, double gap);
/// Returns rings of the default size, 6 cm apart on a square grid.
scene::SceneSpec Rings(int num_rings);
/// Returns tilted rings above each other that fall on a heap.
/// @param sides  of each ring, of which each is a piece
scene::SceneSpec FallingRings(int num_rings, int sides);

/// World of a scene in which no object ever sleeps.
struct AwakeWorld {
  explicit AwakeWorld(const scene::SceneSpec& scene) : tabletop(&world, scene) {}
  void StepSeconds(int seconds);

  physics::World world{{.sleep_linear_speed = 0, .sleep_angular_speed = 0}};
  world::Tabletop tabletop;
};

/// Reports simulated seconds per second of the time that the benchmark measures.
void ReportRealTime(benchmark::State& state, double seconds_per_iteration);

}  // namespace smile::bench
