#pragma once

#include <filesystem>
#include <string>

#include "base/json.h"
#include "brain/brain_values.h"
#include "brain/sensor_noise.h"
#include "scene/scene_spec.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::app {

/// A robot that watched a demonstration acts in a scene of its own.
struct ImitationPlan {
  std::string task;                     ///< its name in the result
  std::filesystem::path demonstration;  ///< a recording
  scene::SceneSpec scene;
  std::filesystem::path brain;
  double patience = 5;           ///< a callback of it may take this long, wall clock [s]
  bool is_attached = false;      ///< somebody starts it in a debugger
  std::filesystem::path record;  ///< new directory for the robot's run
  bool has_pictures = true;      ///< in the recording; the brain gets them anyway
  double max_seconds = 600;      ///< simulated
  sim::EyeSpec eye;
  brain::SensorNoise noise;  ///< in what the brain is told
  std::optional<sim::RobotPlacement> robot;
};

struct ImitationOutcome {
  Json result;  ///< `result.json`, see docs/results.md
  bool is_rebuilt = false;
  std::optional<brain::BrainError> brain_error;
};

/// Runs it and scores how close it came.
/// @throws InputError if demonstration, scene and brain do not fit together.
ImitationOutcome Imitate(const ImitationPlan& plan);

}  // namespace smile::app
