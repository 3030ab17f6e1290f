#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

/// Reads unit and table from the root of the main file. Returns false, with a finding, if it is not
/// a scene.
bool ReadRoot(const SceneElement& root, ReadingContext* reading, scene::SceneSpec* scene);

/// Checks the root of an included file: its table is ignored, and its unit must be that of the
/// scene. Returns false, with a finding, if the file is not a scene.
bool CheckIncludedRoot(const SceneElement& root, ReadingContext* reading);

}  // namespace smile::scene_xml
