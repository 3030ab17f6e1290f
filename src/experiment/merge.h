#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/callbacks.h"

namespace smile::experiment {

/// Joins all shards of a generation or an evaluation in a new folder, which then has the same files
/// as if one process had made it; of an evaluation, except wall-clock times and logs. The shards
/// remain as they are. The folder appears when it is complete.
/// @returns the summary, as text for a terminal.
/// @throws InputError if a shard is missing or given twice, was not completed, was changed since,
///         or belongs to another job or version.
/// @throws std::runtime_error if the folder exists, a file cannot be written, or it is cancelled.
std::string Merge(const std::vector<std::filesystem::path>& shards,
                  const std::filesystem::path& out, const Callbacks& callbacks = {});

}  // namespace smile::experiment
