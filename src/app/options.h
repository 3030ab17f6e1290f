#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brain/brain_process.h"
#include "brain/sensor_noise.h"
#include "scene_xml/scene_reader.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::app {

/// Lets an option be repeated for several values. Each time it takes one value and leaves what
/// follows to positional arguments.
/// @param option  of a vector.
CLI::Option* Repeatable(CLI::Option* option);

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
  std::string urdf;      ///< empty: Baxter
  std::string side_file, gripper;
  model::RobotBodyOptions body;

  bool operator==(const RobotOptions&) const = default;
};

/// `--no-robot` (where a table without one makes sense), `--classic`, `--robot`, `--side-file`,
/// `--gripper`, `--kinematic` and `--friction-grasp`.
void AddRobotOptions(CLI::App* command, bool may_be_absent, RobotOptions* options);

/// The robot in its place; nullopt when it is not wanted. Tells on stderr when nothing moves it.
/// @param path  where the packages of its meshes are.
std::optional<sim::RobotPlacement> PlaceRobot(const RobotOptions& options,
                                              const PathOptions& path = {});

/// Which robot program, and how it is run.
struct BrainOptions {
  std::string brain;
  double patience = brain::kCallbackSeconds;
  bool attach = false;
};

/// `--brain`, `--patience` and `--attach`.
/// @returns the option `--brain`, which some commands require.
CLI::Option* AddBrainOptions(CLI::App* command, BrainOptions* options);

struct PictureSize {
  int width_px = 0, height_px = 0;
};
/// `640x480`.
/// @throws std::invalid_argument saying what was found and expected.
PictureSize ParseSize(const std::string& text);

/// Which of its cameras is the robot's eye.
struct EyeOptions {
  std::string camera = sim::kEyeCamera;
  std::string size;  ///< empty: what is usual for the camera
};

/// `--eye` and `--size`.
void AddEyeOptions(CLI::App* command, EyeOptions* options);

/// @throws std::invalid_argument if the size is none.
sim::EyeSpec EyeSpecOf(const EyeOptions& options);

/// `joints=0.001,image=0.007,depth=0.02,seed=3`, or some of them; empty for none.
/// @throws std::invalid_argument saying what was found and expected.
brain::SensorNoise ParseNoise(const std::string& text);

/// `--noise`.
void AddNoiseOption(CLI::App* command, std::string* text);

/// `--demonstrator`: how the demonstrator is seen in pictures, see recording::DemonstratorLook.
CLI::Option* AddDemonstratorOption(CLI::App* command, std::string* look);

/// Accepts finite numbers from `low` to `high`; CLI::Range would let NaN pass.
CLI::Validator NumberBetween(double low, double high);

/// Accepts any text but the empty one, which a forgotten variable of a shell leaves.
CLI::Validator NotEmpty();

}  // namespace smile::app
