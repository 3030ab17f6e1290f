#include "bench/internal_scenes.h"

#include <chrono>
#include <cmath>
#include <string>

#include "base/files.h"
#include "catalog/placed_robot.h"
#include "scene_xml/scene_reader.h"

namespace smile::bench {
namespace {

/// Returns a scene of equal objects on a square grid, and on each other from a given number on.
/// @param spacing  of the grid [m]
/// @param height   of each object [m]
scene::SceneSpec Grid(int num_objects, int objects_a_stack, double spacing, double height,
                      const scene::Shape& shape) {
  const int num_stacks = (num_objects + objects_a_stack - 1) / objects_a_stack;
  const int num_columns = static_cast<int>(std::ceil(std::sqrt(num_stacks)));
  const double span = num_columns * spacing + 0.2;
  scene::SceneSpec scene{.name = "grid", .table = {.x_span = span, .y_span = span}};
  for (int i = 0; i < num_objects; ++i) {
    const int stack = i / objects_a_stack, level = i % objects_a_stack;
    const int row = stack / num_columns, column = stack % num_columns;
    const Vector3 p_WB((column - 0.5 * (num_columns - 1)) * spacing,
                       (row - 0.5 * (num_columns - 1)) * spacing, (level + 0.5) * height);
    scene::ObjectSpec object;
    object.whole = {.id = "cube" + std::to_string(i), .X_PE = RigidTransform(p_WB), .shape = shape};
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

/// Length of the way of a hand that carries [m].
constexpr double kCarryingDistance = 0.4;

void SetTimeSince(std::chrono::steady_clock::time_point start, benchmark::State* state) {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  state->SetIterationTime(passed.count());
}

}  // namespace

scene::SceneSpec UmScene() { return scene_xml::LoadScene(DataFile("scenes/um.xml")); }

std::optional<sim::RobotPlacement> Place(const BenchRobot& robot) {
  if (robot.is_missing) return std::nullopt;
  return catalog::PlaceRobot(
             robot.name, {.gripper = robot.gripper, .body = {.is_kinematic = robot.is_kinematic}})
      .placement;
}

std::unique_ptr<sim::Simulation> MakeUm(const BenchRobot& robot) {
  auto simulation = std::make_unique<sim::Simulation>(UmScene(), Place(robot));
  for (int i = 0; i < 3 * sim::kTicksPerSecond; ++i) simulation->Tick();
  return simulation;
}

void Swing(sim::Simulation* simulation) {
  if (simulation->tick() % kSwingTicks != 0) return;
  const double speed = kSwingAngle / sim::SecondsOf(kSwingTicks);
  const bool is_forth = simulation->tick() / kSwingTicks % 2 == 0;
  sim::JointVelocities command;
  for (const robot::Arm& arm : simulation->model().robot()->arms) {
    command.arms[arm.name] = std::vector(arm.joints.size(), is_forth ? speed : -speed);
  }
  simulation->Apply(command);
}

Carrying::Carrying(sim::Simulation* simulation, const std::string& object, const Vector3& p_WFrom)
    : simulation_(simulation), p_WFrom_(p_WFrom) {
  simulation_->Apply(sim::Grasp{.object = object});
  for (int i = 0; i < 5 * sim::kTicksPerSecond; ++i) Tick();
}

void Carrying::Tick() {
  if (num_ticks_ % sim::kTicksPerSecond == 0) {
    const bool is_back = num_ticks_ / sim::kTicksPerSecond % 2 == 0;
    simulation_->Apply(sim::MoveTo{
        .p_WH = p_WFrom_ + Vector3(is_back ? 0 : kCarryingDistance, 0, 0), .speed = 0.4});
  }
  ++num_ticks_;
  simulation_->Tick();
}

void SaveAfterTicks(benchmark::State& state, Carrying* carrying, sim::Simulation* simulation) {
  for (auto _ : state) {
    carrying->Tick();
    const auto start = std::chrono::steady_clock::now();
    const sim::SimulationState saved = simulation->Save();
    SetTimeSince(start, &state);
  }
}

void RestoreOverTicks(benchmark::State& state, Carrying* carrying, sim::Simulation* simulation) {
  for (auto _ : state) {
    const sim::SimulationState saved = simulation->Save();
    simulation->Tick();
    const auto start = std::chrono::steady_clock::now();
    simulation->Restore(saved);
    SetTimeSince(start, &state);
    carrying->Tick();
  }
}

scene::SceneSpec Stacks(int num_cubes, int cubes_a_stack, double edge, double gap) {
  return Grid(num_cubes, cubes_a_stack, edge + gap, edge, scene::Block{{edge, edge, edge}});
}

scene::SceneSpec Rings(int num_rings) {
  constexpr double kGap = 0.06;
  const scene::Ring ring;
  return Grid(num_rings, 1, 2 * ring.radius_outer + kGap, ring.height, ring);
}

scene::SceneSpec FallingRings(int num_rings, int sides) {
  const scene::Ring ring{.sides = sides};
  // Columns of five, in which rings do not overlap at the start, however they are tilted.
  const double diameter = 2 * ring.radius_outer + ring.height;
  scene::SceneSpec scene = Grid(num_rings, 5, ring.radius_outer + diameter / 2, diameter, ring);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    RigidTransform& X_WB = scene.objects[i].whole.X_PE;
    const double angle = 0.3 + 0.2 * static_cast<double>(i % 4);
    const Vector3 axis = i % 2 == 0 ? Vector3::UnitX() : Vector3::UnitY();
    X_WB = RigidTransform(Quaternion(Eigen::AngleAxisd(angle, axis)), X_WB.translation());
  }
  return scene;
}

void AwakeWorld::StepSeconds(int seconds) {
  const long num_steps = std::lround(seconds / world.config().step_seconds);
  for (long i = 0; i < num_steps; ++i) world.Step();
}

void ReportRealTime(benchmark::State& state, double seconds_per_iteration) {
  state.counters["x_real_time"] = benchmark::Counter(
      seconds_per_iteration * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

}  // namespace smile::bench
