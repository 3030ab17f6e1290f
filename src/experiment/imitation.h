#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/json.h"
#include "brain/brain_values.h"
#include "brain/function_brain.h"
#include "brain/sensor_noise.h"
#include "experiment/brain_setup.h"
#include "experiment/callbacks.h"
#include "experiment/disturbance.h"
#include "experiment/looks.h"
#include "scene/scene_spec.h"
#include "sim/eye.h"
#include "sim/simulation.h"
#include "task/imitation_result.h"

namespace smile::experiment {

/// An imitation: a robot that was given a demonstration acts in a scene of its own.
struct ImitationPlan {
  std::string task;                     ///< its name in the result
  std::filesystem::path demonstration;  ///< recording
  /// `analysis.json` of the demonstration, which the brain is given; empty for none.
  std::filesystem::path analysis;
  scene::SceneSpec scene;
  Looks looks;  ///< that the scene gets; objects are told apart by the colors they had before
  std::filesystem::path brain;
  brain::MessageFunction brain_function;              ///< in place of `brain`; empty for none
  double callback_seconds = brain::kCallbackSeconds;  ///< timeout per callback, wall clock [s]
  bool is_attached = false;                           ///< a person starts the brain in a debugger
  std::filesystem::path record;               ///< new directory for the recording of the robot
  bool has_pictures = true;                   ///< in the recording; the brain gets them anyway
  double max_seconds = kMaxImitationSeconds;  ///< simulated, from the end of watching
  /// From the end of the brain to the state that is scored [s]: what it built must still stand.
  double hold_seconds = task::kRestSeconds;
  bool is_verified = false;  ///< replayed at the end: a success must replay to the last bit
  sim::EyeSpec eye;
  brain::SensorNoise noise;                ///< in the sensor values of the brain
  brain::BehaviorVariation behavior;       ///< that the brain is asked for
  bool gives_poses = false;                ///< the brain is given the true poses of all objects
  std::optional<Disturbance> disturbance;  ///< while the brain acts
  std::optional<sim::RobotPlacement> robot;
};

struct ImitationResult {
  Json json;                   ///< `result.json`, see docs/results.md
  bool has_succeeded = false;  ///< see task::IsSuccess()
  std::optional<brain::BrainError> brain_error;
};

/// Runs an imitation, and scores it against the demonstration some seconds after the end of the
/// brain. A cancelled run is scored up to that point.
/// @throws InputError if demonstration, scene and brain do not fit together.
ImitationResult Imitate(const ImitationPlan& plan, const Callbacks& callbacks = {});

}  // namespace smile::experiment
