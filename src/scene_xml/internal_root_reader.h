#pragma once

#include <string>

#include "scene/scene_spec.h"
#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_xml_tree.h"

namespace smile::scene_xml {

/// The root of the main file: its unit and its table. False, with a finding, when it is no scene
/// at all.
bool ReadRoot(const XmlElement& root, Reading* reading, scene::SceneSpec* scene);

/// The root of an included file: it says nothing about the table, and its unit must be that of the
/// scene. False, with a finding, when the file is no scene at all.
bool CheckIncludedRoot(const XmlElement& root, Reading* reading);

/// ReadFile() begins its messages with the path, which a diagnostic already names.
std::string WithoutPath(std::string reason, const std::string& file);

}  // namespace smile::scene_xml
