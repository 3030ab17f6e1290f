#pragma once

#include <vector>

#include "scene/camera_spec.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

/// Appends the camera of an element, unless it has faults.
void ReadCamera(const SceneElement& element, ReadingContext* reading,
                std::vector<scene::CameraSpec>* cameras);

}  // namespace smile::scene_xml
