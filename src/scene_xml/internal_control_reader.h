#pragma once

#include <span>
#include <string_view>

#include "scene/shape.h"
#include "scene_xml/internal_attribute_reader.h"

namespace smile::scene_xml {

/// The states and downstreams of a control, and the checks that need them.
///
/// @param attributes  those of `element`, for the checks.
/// @param others      words a message should say may stand there too.
void ReadControlContent(std::span<const SceneElement* const> content,
                        std::span<const std::string_view> others, AttributeReader* attributes,
                        scene::Shape* control, Reading* reading);

}  // namespace smile::scene_xml
