#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene_spec.h"

namespace smile::task {

/// Of objects by id: which of their properties matter, as the demonstrator told.
using Attention = std::map<std::string, std::vector<std::string>>;

/// True when one object can play the part of another: nobody who does not know their ids can tell
/// them apart.
///
/// @param properties  that matter of `wanted`. Of these only `color`, `size` (its extent along its
///                    own axes), `shape` (as described: a plank is a block) and its descriptions
///                    are about looks. If none of these was told, all that can be seen counts.
bool AreAlike(const scene::ObjectSpec& wanted, const scene::ObjectSpec& other,
              const std::vector<std::string>& properties = {});

/// True when both have the same pieces, of whatever color.
bool AreOfOneForm(const scene::ObjectSpec& a, const scene::ObjectSpec& b);

}  // namespace smile::task
