#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/imitate_arguments.h"
#include "experiment/evaluation.h"

namespace smile::app {

/// Options of `smile evaluate`.
struct EvaluateOptions {
  std::string demo, scene, level, out, keep = "failures";
  std::vector<std::string> brains, demonstrators;
  bool no_symbols = false;
  std::size_t scenes = 10;
  std::uint64_t seed = 1;
  EyeOptions eye;
  std::string noise;
  ImitateSettings settings;
  PoolOptions pool;
  bool json = false;
};

/// Returns the evaluation that the options describe. Its runs are executed by `smile imitate`.
/// @throws InputError or std::invalid_argument if an option is invalid, before anything is written.
experiment::EvaluationPlan PlanOf(const EvaluateOptions& options);

}  // namespace smile::app
