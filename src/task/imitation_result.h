#pragma once

#include <string>

#include "base/json.h"
#include "task/episode.h"
#include "task/structure.h"

namespace smile::task {

/// What a demonstration achieved, and the scene in which somebody else is to achieve it.
struct Exercise {
  std::string name;  ///< in the result
  Structure structure;
  scene::SceneSpec scene;  ///< as it was before
};

/// @throws InputError if there is nothing to imitate, or something is missing in the scene.
Exercise MakeExercise(std::string name, const recording::Recording& demonstration,
                      scene::SceneSpec scene);

/// What the recording of an imitation does not tell.
struct Circumstances {
  double seconds = 0;          ///< that it took, simulated, from the end of watching
  double watched_seconds = 0;  ///< before that, in which the program watched the demonstration
  double realtime_factor = 0;  ///< how much faster than the clock it ran
  Json brain;                  ///< with `status` and `message`
};

/// What came of it, as `result.json` tells it (docs/results.md).
/// @param outcome  in the exercise's scene.
Json ResultOf(const Exercise& exercise, const Episode& outcome, const Circumstances& circumstances);

}  // namespace smile::task
