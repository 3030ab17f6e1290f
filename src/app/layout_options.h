#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "layout/layout_choice.h"

namespace smile::app {

/// Options for random starting positions of the loose objects of a scene.
struct LayoutOptions {
  std::optional<std::uint64_t> seed;
  std::string level{layout::kLayoutLevelWords.front()};

  layout::LayoutChoice choice() const {
    return {.seed = seed, .level = layout::ParseLayoutLevel(level).value()};
  }
};

/// Adds `--seed` and `--level`.
/// @returns the option `--seed`, which some commands require.
CLI::Option* AddLayoutOptions(CLI::App* command, LayoutOptions* options);

/// Returns a validator for the names of levels.
CLI::Validator IsLayoutLevel();

}  // namespace smile::app
