#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_xml_text.h"

namespace smile::scene_xml {

/// @param X_PE  where it stands in what is around it: for members of sliders not the world.
void WriteObject(const scene::ObjectSpec& object, const RigidTransform& X_PE, XmlText* text);

/// A part of a composite or of a state.
void WritePart(const scene::Part& part, XmlText* text);

}  // namespace smile::scene_xml
