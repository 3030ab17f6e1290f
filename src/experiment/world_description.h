#pragma once

#include "base/json.h"
#include "sim/simulation.h"

namespace smile::experiment {

// Parts of the state of a simulation in the format of results: positions in units of the scene
// file, angles of objects in degrees, joints in radians (docs/commands.md).

/// Objects that are present: id -> {position [units], rotation [degrees about the fixed axes]}.
Json DescribeObjects(const sim::Simulation& simulation);

/// Controls that are present: id -> state as in recordings (model::RecordedState()).
Json DescribeControls(const sim::Simulation& simulation);

/// Arms by name: {joints [rad], gripper opening [units], end_effector [units]}; and the angle of
/// the head [rad]. Null without a robot.
Json DescribeRobot(const sim::Simulation& simulation);

}  // namespace smile::experiment
