#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "layout/layout.h"
#include "scene/scene_spec.h"

namespace smile::app {

/// Where the loose objects of a scene start, if not where the scene has them.
struct LayoutOptions {
  std::optional<std::uint64_t> seed;
  std::string level{layout::kLayoutLevelWords.front()};
};

/// `--seed` and `--level`.
/// @returns the option `--seed`, which some commands require.
CLI::Option* AddLayoutOptions(CLI::App* command, LayoutOptions* options);

/// The scene as the options want it: as it is, without a seed.
/// @throws std::invalid_argument if there is no such layout.
scene::SceneSpec LaidOut(scene::SceneSpec scene, const LayoutOptions& options);

}  // namespace smile::app
