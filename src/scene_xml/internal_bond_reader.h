#pragma once

#include "scene/bond.h"
#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

scene::GuestPoint ReadGuestPoint(const SceneElement& element, Reading* reading);
scene::HostPoint ReadHostPoint(const SceneElement& element, Reading* reading);

}  // namespace smile::scene_xml
