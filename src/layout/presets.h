#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "math/rigid_transform.h"
#include "scene/bounds.h"
#include "scene/scene_spec.h"
#include "texts/user_message.h"

namespace smile::layout {

/// Objects that can be added to the table at any time.
struct Preset {
  const char* name;
  texts::UserMessage title;
};

/// Returns all presets in the order of the menu: those of the original program first.
const std::vector<Preset>& Presets();

/// Context of a placement: table, occupied space and existing ids.
struct PlacementContext {
  double meters_per_unit = scene::kMetersPerUnit;
  scene::TableSpec table;
  std::vector<scene::Bounds> taken;  ///< of objects already there, in the world
  std::set<std::string> ids;         ///< existing ids
};

/// Returns a preset's objects at a free place of the table, rotated about the vertical, as a scene
/// of their own. Place, rotation and colors depend on the seed only, given the same context; ids
/// are new.
/// @returns nullopt if there is no free place on the table.
/// @throws std::invalid_argument if there is no such preset.
std::optional<scene::SceneSpec> MakePreset(const std::string& preset,
                                           const PlacementContext& context, std::uint64_t seed);

/// The same at a given place, not rotated.
/// @param p_WQ  point under the middle of the objects [m], taken or not.
scene::SceneSpec MakePreset(const std::string& preset, const PlacementContext& context,
                            std::uint64_t seed, const Vector3& p_WQ);

}  // namespace smile::layout
