#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/imitate_arguments.h"
#include "app/variation_options.h"
#include "experiment/generation.h"

namespace smile::app {

/// Options of `smile generate`.
struct GenerateOptions {
  std::string demo, brain, out, noise;
  std::vector<std::string> scenes, levels, eyes;
  VariationOptions variation;
  std::size_t count = 100, tries = 5;
  std::uint64_t seed = 1;
  double hold = 2;
  ImitateSettings settings;
  PoolOptions pool;
  bool json = false;
};

/// Returns the generation that the options describe. Its runs are executed by `smile imitate`.
/// @throws InputError or std::invalid_argument if an option is invalid, before anything is written.
experiment::GenerationPlan PlanOf(const GenerateOptions& options);

}  // namespace smile::app
