#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/options.h"

namespace smile::app {

/// Options of `smile imitate` that are the same for all runs of a command that starts many.
struct ImitateSettings {
  double max_seconds = 600, timeout = 60;
  std::string size;  ///< of the pictures of the eye
  std::string plan;  ///< analysis.json of the demonstration
  bool oracle = false;
  RobotOptions robot;
  PathOptions path;
};

/// Adds `--seconds`, `--timeout` and the options of robot and paths.
void AddImitateSettings(CLI::App* command, ImitateSettings* settings);

/// Options of a pool of runs.
struct PoolOptions {
  std::size_t jobs = 0;        ///< 0: the number of cores
  double wall_seconds = 3600;  ///< limit of a run
  std::string shard = "1/1";
  std::size_t slurm_shards = 0;  ///< tasks of a job of Slurm; 0: without Slurm
};

/// Adds `--jobs`, `--wall-seconds`, `--shard` and `--slurm`.
void AddPoolOptions(CLI::App* command, PoolOptions* options);

/// Up to here all integers are exact in JSON numbers.
inline constexpr std::uint64_t kMaxSeed = std::uint64_t{1} << 53;

/// Returns the settings as arguments of `smile imitate`, except those that have their defaults.
/// @param eye    camera.
/// @param noise  see ParseNoise().
std::vector<std::string> ArgumentsOf(const ImitateSettings& settings, const std::string& eye,
                                     const std::string& noise);

/// Returns the remaining time of long work, as `, about 5 min left`.
std::string TimeLeftText(double seconds);

}  // namespace smile::app
