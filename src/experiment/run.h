#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "brain/brain_driver.h"
#include "brain/function_brain.h"
#include "experiment/callbacks.h"
#include "experiment/disturbance.h"
#include "recorder/recording_controller.h"
#include "scene/scene_spec.h"
#include "sim/eye.h"
#include "sim/script.h"
#include "sim/simulation.h"
#include "task/structure.h"

namespace smile::experiment {

/// Plan of a run without a window: scene, actors, duration and recording.
struct RunPlan {
  scene::SceneSpec scene;
  std::optional<sim::RobotPlacement> robot;
  std::optional<sim::Script> script;
  std::filesystem::path brain;                        ///< empty for none
  brain::MessageFunction brain_function;              ///< in place of `brain`; empty for none
  double callback_seconds = brain::kCallbackSeconds;  ///< timeout per callback, wall clock [s]
  bool is_attached = false;                           ///< a person starts the brain in a debugger
  std::filesystem::path demonstration;  ///< recording that the brain is given; empty for none
  std::optional<brain::TaskPlan> plan;  ///< of the demonstration, for the brain
  std::optional<double> seconds;        ///< exact length [s]; nullopt: until script and brain end
  /// Limit of runs that end by themselves, from the end of watching [s].
  double max_seconds = 86400;
  /// From the end of the brain to the end of the run [s]; by default as long as films show its last
  /// face.
  double seconds_after_brain = 0.25;
  std::filesystem::path record;  ///< new directory of the recording; empty for none
  std::filesystem::path recordings = "recordings";  ///< root of recordings that the script starts
  /// Continues a recording from this point instead of starting one. The plan has the recording's
  /// scene and robot.
  struct Continuation {
    std::filesystem::path recording;
    recording::HistoryPoint from;
  };
  std::optional<Continuation> continuation;
  /// Corrects a recording from this moment on: `record` is the same up to it. The plan has the
  /// recording's scene and robot.
  struct Correction {
    std::filesystem::path recording;
    double seconds = 0;  ///< from the start of the demonstration
  };
  std::optional<Correction> correction;
  recorder::RecorderOptions recording;
  bool has_pictures = true;  ///< in recordings
  sim::EyeSpec eye;
  brain::SensorNoise noise;                ///< in the sensor values of the brain
  brain::BehaviorVariation behavior;       ///< that the brain is asked for
  bool gives_poses = false;                ///< the brain is given the true poses of all objects
  std::optional<Disturbance> disturbance;  ///< while the brain acts
  double image_seconds = 0.25;             ///< between pictures for the brain
  bool is_realtime = false;                ///< paced by the wall clock, which changes no result
  std::string label = "running";           ///< step name in progress reports
  /// Structure of which progress reports count the objects in place; null for none.
  const task::Structure* goal = nullptr;
};

/// End state and statistics of a run.
struct RunResult {
  std::uint64_t ticks = 0;       ///< of the simulation's clock
  double seconds = 0;            ///< the same in seconds
  std::uint64_t state_hash = 0;  ///< of the end state
  double wall_seconds = 0;
  double realtime_factor = 0;  ///< simulated time over wall-clock time
  bool is_realtime = false;
  std::uint64_t late_ticks = 0;  ///< of a paced run: ticks that were done after they were due
  double worst_delay = 0;        ///< the longest of these delays [s]
  std::optional<brain::BrainStatus> brain_status;  ///< nullopt without a brain
  double watched_seconds = 0;      ///< of `seconds`, in which the brain watched the demonstration
  double seconds_after_brain = 0;  ///< of `seconds`, after its end
  std::optional<brain::BrainError> brain_error;
  std::optional<brain::Claim> brain_claim;
  std::vector<std::filesystem::path> recordings;  ///< started or continued, in order
  Json objects, controls, robot;                  ///< see world_description.h
  Json disturbance;                               ///< see Disturber::json()
};

/// `brain` of a result: {status, message, claim}.
Json BrainJson(const RunResult& result);

/// The format of `run --json`, see docs/commands.md.
Json ToJson(const RunResult& result);

/// Runs the plan to its end, or until it is cancelled; a cancelled run is a shorter run.
/// @throws InputError if the script fails or the brain does not exist; everything recorded until
///         then is kept.
/// @throws std::runtime_error if the recording cannot be written.
RunResult Run(const RunPlan& plan, const Callbacks& callbacks = {});

}  // namespace smile::experiment
