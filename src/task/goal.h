#pragma once

#include <map>
#include <string>
#include <vector>

#include "record/recording.h"
#include "scene/scene_spec.h"

namespace smile::task {

/// Poses of objects in the world, by id.
using ObjectPoses = std::map<std::string, RigidTransform>;

/// What a demonstration built: the objects that hands moved and what these stand on, as they lay in
/// the end. The task is to build the same elsewhere on the table.
struct Goal {
  std::vector<scene::ObjectSpec> objects;  ///< in scene order, with their poses of the end

  bool operator==(const Goal&) const = default;
};

/// @throws InputError if the recording's trace cannot be read or no object was moved by a hand.
Goal GoalOf(const record::Recording& demonstration);

/// Which object of another scene plays the part of which object of the goal: the one of the same id
/// if it looks the same (shape, size, color), else the first that looks the same and is still free.
/// @throws InputError naming the objects that have no counterpart.
std::map<std::string, std::string> MatchObjects(const Goal& goal, const scene::SceneSpec& scene);

}  // namespace smile::task
