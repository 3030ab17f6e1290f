#pragma once

#include <cstddef>
#include <filesystem>

namespace smile::app {

/// Gives the command of this process to Slurm instead of executing it: submits an array job with a
/// shard for each task, and a job that joins the shards in `out` when all tasks have ended. Their
/// scripts, logs and shards are in `OUT.slurm`. Tells what was submitted on stdout.
///
/// Submitting the same command again continues what was interrupted.
/// @param num_shards  at least 2.
/// @param num_items   episodes or layouts to divide.
/// @param num_cores   for each shard; 0: one.
/// @throws std::invalid_argument if there are more shards than items, std::runtime_error if `out`
///         exists or Slurm refuses.
void SubmitToSlurm(std::size_t num_shards, std::size_t num_items, std::size_t num_cores,
                   const std::filesystem::path& out);

}  // namespace smile::app
