#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_shape_readers.h"

namespace smile::scene_xml {

/// Reads a whole object with its parts and descriptions.
scene::ObjectSpec ReadObject(const XmlElement& element, const ShapeElement& shape,
                             Reading* reading);

}  // namespace smile::scene_xml
