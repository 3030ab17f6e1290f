#pragma once

#include <optional>

#include "scene/lighting.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

/// Reads a `lighting`; a scene has at most one.
/// @param lighting  that of the elements before; nullopt if there was none.
void ReadLighting(const SceneElement& element, ReadingContext* reading,
                  std::optional<scene::Lighting>* lighting);

}  // namespace smile::scene_xml
