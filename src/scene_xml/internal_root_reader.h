#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

/// The root of the main file: its unit and its table. False, with a finding, when it is no scene
/// at all.
bool ReadRoot(const SceneElement& root, Reading* reading, scene::SceneSpec* scene);

/// The root of an included file: it says nothing about the table, and its unit must be that of the
/// scene. False, with a finding, when the file is no scene at all.
bool CheckIncludedRoot(const SceneElement& root, Reading* reading);

}  // namespace smile::scene_xml
