#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/options.h"
#include "experiment/evaluation.h"

namespace smile::app {

/// Options of `smile evaluate`.
struct EvaluateOptions {
  std::string demo, scene, level, out, keep = "failures";
  std::vector<std::string> brains, demonstrators;
  bool no_symbols = false;
  std::size_t scenes = 10, jobs = 0;
  std::uint64_t seed = 1;
  double max_seconds = 600, wall_seconds = 3600, timeout = 60;
  EyeOptions eye;
  std::string noise;
  RobotOptions robot;
  PathOptions path;
  bool json = false;
};

/// Returns the evaluation that the options describe. Its runs are executed by `smile imitate`.
/// @throws InputError or std::invalid_argument if an option is invalid, before anything is written.
experiment::EvaluationPlan PlanOf(const EvaluateOptions& options);

}  // namespace smile::app
