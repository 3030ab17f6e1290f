#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/bounds.h"
#include "scene/scene_spec.h"

namespace smile::layout {

/// Objects that can be put on the table at any time.
struct Preset {
  const char* name;
  const char* title;  ///< for people
};

/// In the order in which they are offered: those of the original, then ours.
const std::vector<Preset>& Presets();

/// Context of a placement: table, occupied space and ids that are taken.
struct PlacementContext {
  double meters_per_unit = scene::kMetersPerUnit;
  scene::TableSpec table;
  std::vector<scene::Bounds> taken;  ///< by what is there, in the world
  std::set<std::string> ids;         ///< that are taken
};

/// A preset's objects at a free place of the table, turned about the vertical, both by the seed, as
/// a scene of their own. Same context, same seed: same place. Their ids are new, their colors
/// the seed's.
/// @returns nullopt if there is no free place on the table.
/// @throws std::invalid_argument if there is no such preset.
std::optional<scene::SceneSpec> MakePreset(const std::string& preset,
                                           const PlacementContext& context, std::uint64_t seed);

}  // namespace smile::layout
