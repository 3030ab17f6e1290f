#pragma once

#include <cstdint>

#include "demonstrator/demonstrator.h"
#include "physics/snapshot.h"
#include "robot/mood.h"
#include "robot/robot_body.h"
#include "sim/trajectory_follower.h"
#include "world/tabletop.h"

namespace smile::sim {

/// Everything a simulation needs to go on exactly as it would have.
struct SimulationState {
  std::uint64_t tick = 0;
  physics::Snapshot physics;
  world::TabletopState tabletop;
  demonstrator::DemonstratorState demonstrator;
  robot::RobotBodyState robot;
  FollowerState follower;
  bool is_robot_shown = true;
  robot::Mood mood = robot::Mood::kIdle;
};

}  // namespace smile::sim
