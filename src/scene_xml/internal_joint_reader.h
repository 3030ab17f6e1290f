#pragma once

#include "scene_xml/internal_object_list.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

/// Reads a `sliderJoint` and its two members, which join the objects.
void ReadSlider(const SceneElement& element, ReadingContext* reading, ObjectList* objects);

/// Reads a `chain`; its pieces join the objects.
void ReadChain(const SceneElement& element, ReadingContext* reading, ObjectList* objects);

}  // namespace smile::scene_xml
