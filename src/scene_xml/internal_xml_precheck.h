#pragma once

#include <string_view>

#include "scene_xml/internal_findings.h"
#include "scene_xml/scene_reader.h"

namespace smile::scene_xml {

/// Looks at the raw text before the XML parser does: is it XML in UTF-8 at all, and is no tag
/// overloaded with attributes (the parser compares each with each, a million would take hours).
/// False, with the reason in `findings`, when it must not be parsed.
///
/// @param file  of the places in it.
bool PassesPrecheck(std::string_view text, int file, const SceneLimits& limits, Findings* findings);

}  // namespace smile::scene_xml
