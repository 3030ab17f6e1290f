#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_shape_readers.h"

namespace smile::scene_xml {

/// Reads a whole object with its parts and descriptions.
///
/// @param container  of whole objects.
scene::ObjectSpec ReadObject(const SceneElement& element, const ShapeElement& shape,
                             Container container, ReadingContext* reading);

}  // namespace smile::scene_xml
