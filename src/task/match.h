#pragma once

#include <map>
#include <string>
#include <vector>

#include "task/structure.h"

namespace smile::task {

/// Objects of another scene by the id of the demonstrated object whose counterpart they are.
using Match = std::map<std::string, std::string>;

/// Returns a match by appearance, before anything is done: the object of the same id if it is alike
/// (see AreAlike() and Structure::attention), else the first one that is alike and still free.
/// @throws InputError naming the objects that have no counterpart.
Match MatchObjects(const Structure& structure, const scene::SceneSpec& scene);

}  // namespace smile::task
