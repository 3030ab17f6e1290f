#pragma once

#include <optional>
#include <string>

#include "base/json.h"
#include "base/json_node.h"
#include "task/episode.h"
#include "task/structure.h"

namespace smile::task {

/// Time from the end of a program to the state that is scored [s]: what it built must still stand.
inline constexpr double kRestSeconds = 2;

/// Task of an imitation: the structure that a demonstration achieved, and the scene in which it is
/// to be achieved again.
struct ImitationTask {
  std::string name;  ///< in the result
  Structure structure;
  scene::SceneSpec scene;  ///< as it was before
};

/// Returns the task of imitating a demonstration in a scene.
/// @throws InputError if there is nothing to imitate, something is missing in the scene, or the
///         task is true there before anything happens.
ImitationTask MakeImitationTask(std::string name, const recording::Recording& demonstration,
                                scene::SceneSpec scene);

/// Throws if there is nothing to do in a scene: it is as the demonstration left it, or an object is
/// missing.
/// @throws InputError
void RequireSomethingToDo(const Structure& structure, const scene::SceneSpec& scene);

/// Facts on the run of an imitation that its recording does not contain.
struct RunInfo {
  double seconds = 0;          ///< that it took, simulated, from the end of watching to its own end
  double watched_seconds = 0;  ///< before that, in which the program watched the demonstration
  double realtime_factor = 0;  ///< simulated time per wall-clock time
  Json brain;                  ///< with `status` and `message`
};

/// Returns the result of an imitation, the content of `result.json` (docs/results.md).
/// @param outcome  the episode of the imitation, in the task's scene.
Json ResultOf(const ImitationTask& task, const Episode& outcome, const RunInfo& run_info);

/// Claim of a program in a result.
struct ClaimEnd {
  bool is_done = false;   ///< it claims to have done the task; otherwise it gave up
  bool is_right = false;  ///< this is true
  std::string reason;

  bool operator==(const ClaimEnd&) const = default;
};
/// Returns the claim in a `result.json`; nullopt if the program claimed nothing, and in results of
/// older versions.
/// @throws InputError if it is inconsistent.
std::optional<ClaimEnd> ReadClaim(const JsonNode& result);

/// Returns the field `success` of a `result.json`; in format 1 it is called `rebuilt`.
/// @throws InputError if the format is newer than this program, or the field is missing.
bool ReadSuccess(const JsonNode& result);

}  // namespace smile::task
