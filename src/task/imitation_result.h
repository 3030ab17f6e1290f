#pragma once

#include <map>
#include <string>

#include "base/json.h"
#include "scene/scene_spec.h"
#include "task/goal.h"

namespace smile::task {

/// A demonstration, and the scene in which somebody else is to do it.
struct Exercise {
  std::string name;  ///< in the result
  Goal goal;
  std::map<std::string, std::string> match;  ///< see MatchObjects()
  scene::SceneSpec scene;                    ///< as it was before
};

/// What came of it, as `result.json` tells it (docs/results.md); how long it took and how the robot
/// program fared is the caller's to add.
/// @param final_poses  of all objects of the scene.
Json ResultOf(const Exercise& exercise, const ObjectPoses& final_poses);

/// Where the objects of a scene begin.
ObjectPoses StartOf(const scene::SceneSpec& scene);

}  // namespace smile::task
