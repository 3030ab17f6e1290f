#pragma once

#include "scene/bond.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"

namespace smile::scene_xml {

scene::GuestPoint ReadGuestPoint(const SceneElement& element, ReadingContext* reading);
scene::HostPoint ReadHostPoint(const SceneElement& element, ReadingContext* reading);

}  // namespace smile::scene_xml
