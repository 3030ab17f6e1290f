#pragma once

#include "scene/shape.h"
#include "scene_xml/internal_attribute_reader.h"

namespace smile::scene_xml {

// Read the attributes that are specific to each kind of control.
/// Reads `trigger`, `pressForce` and `pressAngle`.
/// @param cause  the default of `trigger`.
scene::TriggerRule ReadTriggerRule(scene::TriggerCause cause, AttributeReader* attributes);

scene::Shape ReadToggleSwitch(AttributeReader* attributes);
scene::Shape ReadIndicatorLights(AttributeReader* attributes);
scene::Shape ReadCustomControl(AttributeReader* attributes);

}  // namespace smile::scene_xml
