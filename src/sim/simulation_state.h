#pragma once

#include <cstdint>
#include <memory>

#include "demonstrator/demonstrator.h"
#include "physics/snapshot.h"
#include "robot/mood.h"
#include "sim/trajectory_follower.h"
#include "world/robot_body.h"
#include "world/tabletop.h"

namespace smile::sim {

/// Everything a simulation needs to go on exactly as it would have.
struct SimulationState {
  std::uint64_t tick = 0;
  std::shared_ptr<const model::Model> model;  ///< of all that follows; it outlives the simulation
  physics::Snapshot physics;
  world::TabletopState tabletop;
  demonstrator::DemonstratorState demonstrator;
  world::RobotBodyState robot;
  FollowerState follower;
  bool is_robot_shown = true;
  robot::Mood mood = robot::Mood::kIdle;
};

}  // namespace smile::sim
