#pragma once

#include <span>
#include <string_view>

#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_shape_readers.h"
#include "scene_xml/internal_xml_tree.h"

namespace smile::scene_xml {

/// False, with a finding, when the element is in another namespace than ours. What is inside such
/// an element is not looked at: one forgotten `xmlns` is one finding.
bool CheckNamespace(const XmlElement& element, Reading* reading);

/// The reader of an element that should be a shape; nullptr, with a finding, when it is none.
const ShapeElement* FindShape(const XmlElement& element, Reading* reading);

/// Adds `found an unknown element, expected …`; no `expected` at all means none may stand there.
void RefuseElement(const XmlElement& element, std::span<const std::string_view> expected,
                   Reading* reading);

}  // namespace smile::scene_xml
