#pragma once

#include <benchmark/benchmark.h>

#include <memory>

#include "physics/world.h"
#include "scene/scene_spec.h"
#include "sim/simulation.h"
#include "world/tabletop.h"

namespace smile::app {

// Scenes that several benchmarks measure.

/// Returns the scene `um`: ten blocks and two planks.
scene::SceneSpec UmScene();
/// Returns a simulation of the scene `um` that has had three simulated seconds to come to rest.
/// @param is_kinematic  see model::RobotBodyOptions; unused without a robot.
std::unique_ptr<sim::Simulation> MakeUm(bool with_robot, bool is_kinematic = false);
/// Moves both arms of the robot to and fro, each joint at 0.3 rad/s for half a second. Call before
/// each tick.
void Swing(sim::Simulation* simulation);

/// Returns stacks of cubes on a square grid that the table just holds.
/// @param edge  of each cube [m]
/// @param gap   between neighboring stacks [m]
scene::SceneSpec Stacks(int num_cubes, int cubes_a_stack, double edge, double gap);
/// Returns rings of the default size, 6 cm apart on a square grid.
scene::SceneSpec Rings(int num_rings);

/// World of a scene in which no object ever sleeps.
struct AwakeWorld {
  explicit AwakeWorld(const scene::SceneSpec& scene) : tabletop(&world, scene) {}
  void StepSeconds(int seconds);

  physics::World world{{.sleep_linear_speed = 0, .sleep_angular_speed = 0}};
  world::Tabletop tabletop;
};

/// Reports simulated seconds per second of the time that the benchmark measures.
void ReportRealTime(benchmark::State& state, double seconds_per_iteration);

}  // namespace smile::app
