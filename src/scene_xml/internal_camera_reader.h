#pragma once

#include <vector>

#include "scene/camera_spec.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

/// Appends the camera of an element, unless it has faults.
void ReadCamera(const SceneElement& element, ReadingContext* reading,
                std::vector<scene::CameraSpec>* cameras);

/// Reads a `cameraOffset`, and adds it to the others.
void ReadCameraOffset(const SceneElement& element, ReadingContext* reading,
                      std::vector<scene::CameraOffset>* offsets);

}  // namespace smile::scene_xml
