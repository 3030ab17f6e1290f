#pragma once

#include <string>

#include "base/json.h"
#include "base/json_node.h"
#include "task/episode.h"
#include "task/structure.h"

namespace smile::task {

/// Task of an imitation: the structure that a demonstration achieved, and the scene in which it is
/// to be achieved again.
struct ImitationTask {
  std::string name;  ///< in the result
  Structure structure;
  scene::SceneSpec scene;  ///< as it was before
};

/// Returns the task of imitating a demonstration in a scene.
/// @throws InputError if there is nothing to imitate, or something is missing in the scene.
ImitationTask MakeImitationTask(std::string name, const recording::Recording& demonstration,
                                scene::SceneSpec scene);

/// Facts on the run of an imitation that its recording does not contain.
struct RunInfo {
  double seconds = 0;          ///< that it took, simulated, from the end of watching
  double watched_seconds = 0;  ///< before that, in which the program watched the demonstration
  double realtime_factor = 0;  ///< simulated time per wall-clock time
  Json brain;                  ///< with `status` and `message`
};

/// Returns the result of an imitation, the content of `result.json` (docs/results.md).
/// @param outcome  the episode of the imitation, in the task's scene.
Json ResultOf(const ImitationTask& task, const Episode& outcome, const RunInfo& run_info);

/// Returns the field `success` of a `result.json`; in format 1 it is called `rebuilt`.
/// @throws InputError if the format is newer than this program, or the field is missing.
bool ReadSuccess(const JsonNode& result);

}  // namespace smile::task
