#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "experiment/variation.h"

namespace smile::app {

/// Options of what `smile generate` varies beside scene, level, eye and noise, as they were typed.
struct VariationOptions {
  std::string looks, jitter, disturb, speed;
  std::vector<std::string> patterns, jittered_cameras, choices;
};

void AddVariationOptions(CLI::App* command, VariationOptions* options);

/// Adds the choices that the options describe.
/// @throws std::invalid_argument with what was found and expected.
void AddChoices(const VariationOptions& options, experiment::VariationChoices* choices);

}  // namespace smile::app
