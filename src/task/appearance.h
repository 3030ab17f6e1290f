#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene_spec.h"
#include "scene/solid.h"

namespace smile::task {

/// Properties that matter, by object id, as the demonstrator specified.
using Attention = std::map<std::string, std::vector<std::string>>;

/// Appearance of an object, without its pose and id.
struct Appearance {
  std::vector<scene::Solid> form;  ///< its pieces, without ids and colors
  std::vector<Color> colors;       ///< of the pieces
  std::size_t shape = 0;           ///< index of the alternative of scene::Shape
  std::vector<scene::Description> descriptions;
};
Appearance AppearanceOf(const scene::ObjectSpec& object);

/// True if one object can be the counterpart of another: without their ids they are
/// indistinguishable.
///
/// @param properties  that matter of `wanted`. Of these only `color`, `size` (its extent along its
///                    own axes), `shape` (as described: a plank is a block) and its descriptions
///                    concern the appearance. If none of these is given, all visible properties
///                    count.
bool AreAlike(const Appearance& wanted, const Appearance& other,
              const std::vector<std::string>& properties = {});

}  // namespace smile::task
