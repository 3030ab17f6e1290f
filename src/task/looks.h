#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene_spec.h"
#include "scene/solid.h"

namespace smile::task {

/// Of objects by id: which of their properties matter, as the demonstrator told.
using Attention = std::map<std::string, std::vector<std::string>>;

/// What an object looks like, apart from where it is and what it is called.
struct Looks {
  std::vector<scene::Solid> form;  ///< its pieces, without ids and colors
  std::vector<Color> colors;       ///< of the pieces
  std::size_t shape = 0;           ///< which of the shapes of scene::Shape
  std::vector<scene::Description> descriptions;
};
Looks LooksOf(const scene::ObjectSpec& object);

/// True when one object can play the part of another: nobody who does not know their ids can tell
/// them apart.
///
/// @param properties  that matter of `wanted`. Of these only `color`, `size` (its extent along its
///                    own axes), `shape` (as described: a plank is a block) and its descriptions
///                    are about looks. If none of these was told, all that can be seen counts.
bool AreAlike(const Looks& wanted, const Looks& other,
              const std::vector<std::string>& properties = {});

}  // namespace smile::task
