#pragma once

#include <span>
#include <string_view>

#include "scene/shape.h"
#include "scene_xml/internal_attribute_reader.h"

namespace smile::scene_xml {

/// Reads the states and downstreams of a control and makes the checks that need them.
///
/// @param attributes  those of `element`, for the checks.
/// @param others  further element names that messages list as expected.
void ReadControlContent(std::span<const SceneElement* const> content,
                        std::span<const std::string_view> others, AttributeReader* attributes,
                        scene::Shape* control, ReadingContext* reading);

}  // namespace smile::scene_xml
