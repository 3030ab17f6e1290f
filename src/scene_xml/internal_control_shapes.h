#pragma once

#include "scene/shape.h"
#include "scene_xml/internal_attribute_reader.h"

namespace smile::scene_xml {

// The attributes each kind of control has of its own.
scene::Shape ReadToggleSwitch(AttributeReader* attributes);
scene::Shape ReadIndicatorLights(AttributeReader* attributes);
scene::Shape ReadCustomControl(AttributeReader* attributes);

}  // namespace smile::scene_xml
