#pragma once

#include "scene/bond.h"
#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_xml_tree.h"

namespace smile::scene_xml {

scene::GuestPoint ReadGuestPoint(const XmlElement& element, Reading* reading);
scene::HostPoint ReadHostPoint(const XmlElement& element, Reading* reading);

}  // namespace smile::scene_xml
