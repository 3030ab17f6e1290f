#pragma once

#include <cstdint>
#include <memory>

#include "demonstrator/demonstrator.h"
#include "physics/snapshot.h"
#include "sim/simulated_robot.h"
#include "world/tabletop.h"

namespace smile::sim {

/// Everything a simulation needs to go on exactly as it would have.
struct SimulationState {
  std::uint64_t tick = 0;
  /// With which it began, and that of all that follows: they outlive the simulation.
  std::shared_ptr<const model::Model> start_model, model;
  physics::Snapshot physics;
  world::TabletopState tabletop;
  demonstrator::DemonstratorState demonstrator;
  SimulatedRobotState robot;
};

}  // namespace smile::sim
