#pragma once

#include "scene/tool.h"
#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

/// Reads the `tool` element of an object.
scene::ToolSpec ReadTool(const SceneElement& element, ReadingContext* reading);

/// Reads the `accepts` element of a guest point.
scene::ToolPlace ReadToolPlace(const SceneElement& element, ReadingContext* reading);

/// Returns the type of tools, an attribute of this name: a word as that of bond points.
std::string ReadTypeWord(std::string_view name, AttributeReader* attributes);

/// Reads `cut`, whether tools can cut it.
bool ReadCut(bool fallback, AttributeReader* attributes);

}  // namespace smile::scene_xml
