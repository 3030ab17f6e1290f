#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene_spec.h"

namespace smile::studio {

/// Objects that can be put on the table at any time.
struct Preset {
  const char* name;
  const char* title;  ///< for people
};

/// In the order in which they are offered: those of the original, then ours.
const std::vector<Preset>& Presets();

/// Puts a preset's objects on the table of a scene, at a free place and turned about the vertical,
/// both by the seed. Same scene, same seed: same place. Their ids are new, their colors the seed's.
/// @throws RequestError if there is no such preset, or no free place on the table.
scene::SceneSpec WithPreset(scene::SceneSpec scene, const std::string& preset, std::uint64_t seed);

}  // namespace smile::studio
