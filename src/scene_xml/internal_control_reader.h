#pragma once

#include <span>
#include <string_view>

#include "scene/shape.h"
#include "scene_xml/internal_attribute_reader.h"

namespace smile::scene_xml {

/// Of one control.
inline constexpr int kMaxStates = 256;

// The attributes each kind of control has of its own.
scene::Shape ReadToggleSwitch(AttributeReader* attributes);
scene::Shape ReadIndicatorLights(AttributeReader* attributes);
scene::Shape ReadCustomControl(AttributeReader* attributes);

/// The states and downstreams of a control, and the checks that need them.
///
/// @param attributes  those of `element`, for the checks.
/// @param others      words a message should say may stand there too.
void ReadControlContent(std::span<const XmlElement* const> content,
                        std::span<const std::string_view> others, AttributeReader* attributes,
                        scene::Shape* control, Reading* reading);

}  // namespace smile::scene_xml
