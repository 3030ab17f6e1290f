#pragma once

#include <map>
#include <string>
#include <vector>

#include "task/structure.h"

namespace smile::task {

/// Which object of another scene plays the part of which object of a demonstration.
using Match = std::map<std::string, std::string>;

/// Before anything is done: the one of the same id if it is alike (see AreAlike(), and what the
/// demonstrator told of it), else the first that is alike and still free.
/// @throws InputError naming the objects that have no counterpart.
Match MatchObjects(const Structure& structure, const scene::SceneSpec& scene);

}  // namespace smile::task
