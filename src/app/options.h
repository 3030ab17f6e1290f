#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene_xml/scene_reader.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::app {

/// `--path DIR…`: where scene files look for what they include, after their own folder.
struct PathOptions {
  std::vector<std::string> roots;

  scene_xml::SceneReaderOptions reader() const {
    return {.search_roots = {roots.begin(), roots.end()}};
  }
};
void AddPathOption(CLI::App* command, PathOptions* options);

/// Which robot stands where.
struct RobotOptions {
  bool no_robot = false;
  bool classic = false;  ///< the robot stands where the original put it
  robot::RobotBodyOptions body;
};

/// `--no-robot` (where a table without one makes sense), `--classic`, `--kinematic` and
/// `--friction-grasp`.
void AddRobotOptions(CLI::App* command, bool may_be_absent, RobotOptions* options);

/// Baxter in its place; nullopt when it is not wanted.
std::optional<sim::RobotPlacement> PlaceRobot(const RobotOptions& options);

/// `640x480`.
/// @throws std::invalid_argument saying what was found and expected.
sim::EyeSpec ParseSize(const std::string& text);

/// Accepts finite numbers from `low` to `high`; CLI::Range would let NaN pass.
CLI::Validator NumberBetween(double low, double high);

/// Accepts any text but the empty one, which a forgotten variable of a shell leaves.
CLI::Validator NotEmpty();

}  // namespace smile::app
