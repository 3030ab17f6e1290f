#pragma once

#include "scene/scene_spec.h"
#include "scene_xml/internal_reading_context.h"

namespace smile::scene_xml {

/// Replaces the tickets of references by final ids, then makes the checks that need the whole
/// scene: that initial bonds are possible, and that hosts request states that exist. Faults are
/// findings.
void ConnectMechanisms(scene::SceneSpec* scene, ReadingContext* reading);

}  // namespace smile::scene_xml
