#pragma once

#include <filesystem>

#include "base/json.h"

namespace smile::experiment {

/// Reads a JSON file of at most 16 MiB.
/// @throws InputError if it is missing or no JSON.
Json ReadJsonFile(const std::filesystem::path& file);

}  // namespace smile::experiment
