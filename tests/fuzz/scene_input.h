#pragma once

#include <string>
#include <string_view>

#include "scene_xml/scene_reader.h"

namespace smile::fuzz {

/// Reads a text as a scene file, with limits that keep one input to a fraction of a second; it may
/// include what lies in tests/fuzz/includes.
scene_xml::SceneReading ReadHostileScene(std::string_view text);

/// What is wrong with how we take this text, in words; empty when all is well.
///
/// An invalid text is refused with reasons, each with a file and a line. A scene comes back
/// from its own file the same, and what physics and cameras are made of has only finite numbers.
std::string FaultWithScene(std::string_view text);

}  // namespace smile::fuzz
