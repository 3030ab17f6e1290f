#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_reading.h"

namespace smile::scene_xml {

/// Puts final ids in the place of the tickets of references, then checks what only the whole scene
/// tells: that initial bonds can be, and that hosts force states that exist. Faults are findings.
void ConnectMechanisms(scene::SceneSpec* scene, Reading* reading);

}  // namespace smile::scene_xml
