#pragma once

#include <string>
#include <string_view>

#include "xml/parse.h"

namespace smile::fuzz {

/// Parses a text as the readers of scenes, or as those of robots and meshes do, with limits that
/// small texts reach.
xml::Parsed ParseHostileXml(std::string_view text, xml::Strictness strictness);

/// What is wrong with what xml::Parse() makes of the text; empty when nothing is: it returns a tree
/// within the limits that reads the same from its own text, or diagnostics with lines.
std::string FaultWithXml(std::string_view text);

}  // namespace smile::fuzz
