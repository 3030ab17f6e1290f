#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiment/attempts.h"
#include "experiment/callbacks.h"
#include "experiment/shard.h"
#include "experiment/variation.h"
#include "robot/urdf_reader.h"
#include "scene/scene_spec.h"

namespace smile::experiment {

inline constexpr std::size_t kMaxEpisodes = kSeedsBetweenTries;

/// Scene in which a brain may be tried.
struct GenerationScene {
  std::string name;       ///< as the user wrote it
  scene::SceneSpec spec;  ///< before it is laid out
};

/// Many recordings of a robot from one demonstration: a brain imitates it in random layouts, and
/// what succeeds is kept.
struct GenerationPlan {
  std::filesystem::path demonstration;  ///< recording
  std::vector<GenerationScene> scenes;
  std::vector<robot::RobotFile> robot;  ///< all files of the robot
  std::string brain;                    ///< as the user wrote it
  VariationChoices choices;             ///< its scenes are the names of `scenes`
  std::size_t count = 100;              ///< wanted episodes, at most kMaxEpisodes
  std::size_t tries = 5;                ///< attempts at an episode
  std::uint64_t first_seed = 1;         ///< of the first attempt at the first episode
  Shard shard;                          ///< of the episodes
  std::size_t jobs = 0;                 ///< runs at a time; 0: as many as processor cores
  double wall_seconds = 3600;           ///< limit of a run, wall clock
  std::filesystem::path out;

  std::filesystem::path program;      ///< executable of the runs, whose content they depend on
  std::vector<std::string> settings;  ///< other options of each run
  /// Arguments of the program for an attempt, with results in a folder.
  std::function<std::vector<std::string>(const Attempt& attempt, const std::filesystem::path& out)>
      arguments;
  /// Returns the scene of an attempt, as its run lays it out. Throws std::invalid_argument if this
  /// is not possible.
  std::function<scene::SceneSpec(const Attempt& attempt)> layout;
};

struct GenerationStatus {
  std::size_t wanted = 0, episodes = 0, attempts = 0;  ///< of this shard
  std::optional<double> seconds_left;       ///< estimate [s of wall-clock time]; nullopt: unknown
  std::optional<double> attempts_per_hour;  ///< in this process
};

struct GenerationCallbacks {
  Callbacks common;
  std::function<void(const GenerationStatus& status)> on_status;  ///< several times a second
  std::function<void(const EndedAttempt& ended)> on_failure;
};

/// Makes the wanted episodes, or continues to: what is in the plan's folder is kept. Each episode
/// has attempts of its own, each with a seed of its own, until one succeeds; hence the results
/// depend neither on `jobs` nor on interruptions nor on shards. Layouts that are not possible, or
/// in which there is nothing to do, are attempts without a run.
/// @returns the summary; episodes may be missing where no attempt succeeded.
/// @throws InputError if demonstration, scenes and brain do not fit together, or the folder
///         contains something else; before any run.
/// @throws std::runtime_error if another process uses the folder, a disk is full, or it is
///         cancelled: finished attempts are kept, and the same plan continues with the others.
GenerationSummary Generate(const GenerationPlan& plan, const GenerationCallbacks& callbacks = {});

}  // namespace smile::experiment
