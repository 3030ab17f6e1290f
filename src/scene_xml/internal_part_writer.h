#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_xml_text.h"

namespace smile::scene_xml {

/// @param X_PE  pose of the object in its surroundings: for members of sliders the joint frame,
///              otherwise the world.
void WriteObject(const scene::ObjectSpec& object, const RigidTransform& X_PE, XmlText* text);

/// Writes a part of a composite or of a state.
void WritePart(const scene::Part& part, XmlText* text);

}  // namespace smile::scene_xml
