#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::app {

/// Options that several commands share.
struct RobotOptions {
  bool no_robot = false;
  bool classic = false;  ///< the robot stands where the original put it
};

/// Baxter in its place; nullopt when it is not wanted.
std::optional<sim::RobotPlacement> PlaceRobot(const RobotOptions& options);

/// `640x480`.
/// @throws std::invalid_argument saying what was found and expected.
sim::EyeSpec ParseSize(const std::string& text);

/// Accepts finite numbers from `low` to `high`; CLI::Range would let NaN pass.
CLI::Validator NumberBetween(double low, double high);

}  // namespace smile::app
