#pragma once

#include <cstdint>
#include <memory>

#include "demonstrator/demonstrator.h"
#include "mechanics/snapshot.h"
#include "sim/simulated_robot.h"
#include "world/tabletop.h"

namespace smile::sim {

/// Complete state of a simulation, from which it continues exactly.
struct SimulationState {
  std::uint64_t tick = 0;
  /// Model at the beginning and at present: they outlive the simulation.
  std::shared_ptr<const model::Model> start_model, model;
  mechanics::Snapshot physics;
  world::TabletopState tabletop;
  demonstrator::DemonstratorState demonstrator;
  SimulatedRobotState robot;
};

}  // namespace smile::sim
