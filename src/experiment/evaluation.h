#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiment/callbacks.h"
#include "experiment/evaluation_folder.h"
#include "experiment/shard.h"
#include "process/child_process.h"
#include "report/evaluation.h"
#include "robot/urdf_reader.h"
#include "scene/scene_spec.h"

namespace smile::experiment {

/// Subfolder of an evaluation with the copies of the demonstration, see MakeCopies().
inline constexpr const char* kDemonstratorsFolder = "demonstrators";

/// One imitation of an evaluation, done by a process of its own.
struct ImitationJob {
  std::filesystem::path demonstration, brain;
  std::uint64_t seed = 0;
  std::filesystem::path out;  ///< folder for `result.json` and `imitation/`
};

/// Several brains imitate a demonstration from the same random starting layouts.
struct EvaluationPlan {
  std::filesystem::path demonstration;     ///< recording
  std::filesystem::path analysis;          ///< as ImitationPlan::analysis; also in `settings`
  std::string scene_name;                  ///< as the user wrote it
  scene::SceneSpec scene;                  ///< before it is laid out
  std::string level;                       ///< of the layouts; empty: the usual one
  std::vector<robot::RobotFile> robot;     ///< all files of the robot
  std::vector<std::string> brains;         ///< as the user wrote them
  std::vector<std::string> demonstrators;  ///< each once; empty: the recording as it is
  bool has_symbols = true;                 ///< in the copies with demonstrators
  std::size_t num_scenes = 10;
  std::uint64_t first_seed = 1;
  Shard shard = {};            ///< of the possible layouts
  std::size_t jobs = 0;        ///< runs at a time; 0: as many as processor cores
  double wall_seconds = 3600;  ///< limit of a run, wall clock; a later one counts as hung
  Keep keep = Keep::kFailures;
  std::filesystem::path out;

  std::filesystem::path program;      ///< executable of the jobs, whose content results depend on
  std::vector<std::string> settings;  ///< other options of each run
  /// Arguments of the program for a job. It ends with exit code 0 or 1 after it has written
  /// `result.json`.
  std::function<std::vector<std::string>(const ImitationJob& job)> arguments;
  /// Returns the scene of a seed, as the runs lay it out. Throws std::invalid_argument if this is
  /// not possible. Empty: all layouts are.
  std::function<scene::SceneSpec(std::uint64_t seed)> layout;
  std::string again;  ///< command that repeats a run, for the report
};

/// Progress of an evaluation.
struct EvaluationStatus {
  std::size_t runs = 0, done = 0, successes = 0;
  std::optional<double> seconds_left;  ///< estimate [s of wall-clock time]; nullopt if unknown
};

struct EvaluationCallbacks {
  Callbacks common;
  std::function<void(const EvaluationStatus& status)> on_status;  ///< several times a second
  /// Called when a run failed, with the unique name of its brain.
  std::function<void(const std::string& brain, const report::EvaluatedRun& run)> on_failed_run;
};

/// Leaves out the seeds whose layouts are not possible, or in which there is nothing to do, and
/// says so first. Runs what is not done yet, summarizes all runs, and writes `evaluation.json` and
/// `report.html` into the plan's folder (docs/experiments.md). The results of runs do not depend on
/// `jobs` or on interruptions.
/// @throws InputError if demonstration, scene and brains do not fit together, or no layout is
///         possible; before any run.
/// @throws std::runtime_error if another evaluation uses the folder, a disk is full, or it is
///         cancelled: finished runs are kept, and the same plan continues with the others.
report::Evaluation Evaluate(const EvaluationPlan& plan, const EvaluationCallbacks& callbacks = {});

/// Writes `evaluation.json` and `report.html` into a folder.
void WriteEvaluation(const report::Evaluation& evaluation, const std::filesystem::path& folder);

}  // namespace smile::experiment
