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

/// Makes an option repeatable for several values. Each time it takes one value and leaves the rest
/// to positional arguments.
/// @param option  option of a vector.
CLI::Option* Repeatable(CLI::Option* option);

/// `--path DIR…`: folders to search for files that scenes refer to, after their own folder.
struct PathOptions {
  std::vector<std::string> roots;

  scene_xml::SceneReaderOptions reader() const {
    return {.search_roots = {roots.begin(), roots.end()}};
  }
  bool operator==(const PathOptions&) const = default;
};
void AddPathOption(CLI::App* command, PathOptions* options);

/// Choice and placement of the robot.
struct RobotOptions {
  bool no_robot = false;
  bool classic = false;  ///< placed as in the original
  std::string urdf;      ///< or the name of a robot; empty: Baxter
  std::string side_file, gripper;
  model::RobotBodyOptions body;

  bool operator==(const RobotOptions&) const = default;
};

/// Adds `--no-robot` (if a table without one makes sense), `--classic`, `--robot`, `--side-file`,
/// `--gripper`, `--kinematic` and `--friction-grasp`.
void AddRobotOptions(CLI::App* command, bool may_be_absent, RobotOptions* options);

/// Returns the robot with its placement; nullopt with `--no-robot`. Reports on stderr if it cannot
/// move.
/// @param path  folders with the packages of its meshes; start_pose: see catalog::PlacingOptions.
std::optional<sim::RobotPlacement> PlaceRobot(const RobotOptions& options,
                                              const PathOptions& path = {},
                                              const std::string& start_pose = "");

/// Brain and the way it is run.
struct BrainOptions {
  std::string brain;
  double timeout = brain::kCallbackSeconds;  ///< of a callback [s of wall-clock time]
  bool attach = false;
};

/// Adds `--timeout`, and its earlier name `--patience`, which `--help` does not list.
/// @param brain    option that both need; may be null.
/// @param seconds  the default, and then the value.
void AddTimeoutOption(CLI::App* command, CLI::Option* brain, double* seconds);

/// `--brain`, `--timeout` and `--attach`.
/// @returns the option `--brain`, which some commands require.
CLI::Option* AddBrainOptions(CLI::App* command, BrainOptions* options);

struct PictureSize {
  int width_px = 0, height_px = 0;
};
/// Parses a size such as `640x480`.
/// @throws std::invalid_argument with what was found and expected.
PictureSize ParseSize(const std::string& text);

/// Camera that is the robot's eye.
struct EyeOptions {
  std::string camera = sim::kEyeCamera;
  std::string size;  ///< empty: the default of the camera
};

/// Adds `--eye` and `--size`.
void AddEyeOptions(CLI::App* command, EyeOptions* options);

/// Returns the specification of the eye.
/// @throws std::invalid_argument if the size is invalid.
sim::EyeSpec EyeSpecOf(const EyeOptions& options);

/// Parses `joints=0.001,image=0.007,depth=0.02,seed=3`, or some of them; empty for none.
/// @throws std::invalid_argument with what was found and expected.
brain::SensorNoise ParseNoise(const std::string& text);

/// Adds `--noise`.
void AddNoiseOption(CLI::App* command, std::string* text);

/// Adds `--oracle`.
void AddPlanOption(CLI::App* command, std::string* file);
void AddOracleOption(CLI::App* command, bool* gives_poses);

/// Adds `--demonstrator`: appearance of the demonstrator in pictures, see
/// recording::DemonstratorAppearance.
CLI::Option* AddDemonstratorOption(CLI::App* command, std::string* appearance);

/// Returns a validator for finite numbers from `low` to `high`; CLI::Range would accept NaN.
CLI::Validator NumberBetween(double low, double high);

/// Returns a validator that replaces the former path of a shipped brain by the present one: see
/// library::PresentBrainPath().
CLI::Validator PresentBrain();

/// Returns a validator for any text except the empty one, which an unset shell variable leaves.
CLI::Validator NotEmpty();

}  // namespace smile::app
