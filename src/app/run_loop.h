#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/json.h"
#include "brain/brain_driver.h"
#include "record/recording_desk.h"
#include "scene/scene_spec.h"
#include "sim/eye.h"
#include "sim/script.h"
#include "sim/simulation.h"

namespace smile::app {

/// A run without a window: a scene, who acts in it, how long, what is kept.
struct RunPlan {
  scene::SceneSpec scene;
  std::optional<sim::RobotPlacement> robot;
  std::optional<sim::Script> script;
  std::filesystem::path brain;          ///< empty for none
  double patience = 5;                  ///< a callback of it may take this long, wall clock [s]
  bool is_attached = false;             ///< somebody starts it in a debugger, as told on stderr
  std::filesystem::path demonstration;  ///< for the brain to imitate
  brain::Attention attention;           ///< of it
  std::optional<double> seconds;        ///< exactly this long; else until script or brain end
  double max_seconds = 86400;           ///< for runs that end by themselves
  std::filesystem::path record;         ///< new directory; empty for none
  std::filesystem::path recordings = "recordings";  ///< where those go that the script starts
  /// Goes on with a recording from here, in place of starting one. It has the plan's scene and
  /// robot.
  struct Continuation {
    std::filesystem::path recording;
    record::Moment from;
  };
  std::optional<Continuation> continuation;
  record::RecorderOptions recording;
  bool has_pictures = true;
  sim::EyeSpec eye;
  brain::SensorNoise noise;  ///< in what the brain is told
  double image_seconds = 0.25;
  bool is_realtime = false;
  std::string label;  ///< shown while it runs; empty for silence
};

struct RunOutcome {
  std::uint64_t ticks = 0;
  double wall_seconds = 0;
  std::uint64_t late_ticks = 0;  ///< of a run in real time: those not done when they were due
  double worst_delay = 0;        ///< the most by which one was late [s]
  Json json;                     ///< as docs/commands.md describes `run --json`
  std::optional<brain::BrainError> brain_error;
  std::vector<std::filesystem::path> recordings;  ///< that were made or gone on with
};

/// Objects of a simulation as results tell them: id -> {position [units], rotation [degrees]}.
Json DescribeObjects(const sim::Simulation& simulation);

/// Controls as results tell them: id -> state, as recordings have it (model::RecordedState()).
Json DescribeControls(const sim::Simulation& simulation);

/// Runs the plan to its end, or until the user interrupts.
/// @throws InputError if the script fails or the brain does not exist; what was recorded is kept.
RunOutcome Run(const RunPlan& plan);

}  // namespace smile::app
