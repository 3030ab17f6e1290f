#pragma once

#include <string>
#include <string_view>

#include "scene_import/import_scene.h"

namespace smile::fuzz {

/// Imports a model of another simulator from its text; the root element tells the format. Without
/// files: whatever it names is missing.
/// @throws InputError when it is no model.
scene_import::ImportedScene ImportHostileModel(std::string_view text);

/// What is wrong with how we take this text, in words; empty when all is well.
///
/// A text that is no model is refused with a reason. A scene that is made of one is a valid one: it
/// is the same again when it is written and read.
std::string FaultWithModel(std::string_view text);

}  // namespace smile::fuzz
