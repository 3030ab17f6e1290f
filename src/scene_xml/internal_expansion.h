#pragma once

#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

/// Puts the content of its template in the place of each `instance` and values in the place of each
/// `$…$` expression in an attribute below the root. No `def`, `instance` or `var` is left; what
/// cannot be expanded is dropped, and is a finding.
///
/// @param has_all_files  else a missing template may just be in a missing file: no finding.
void ExpandTemplates(const SceneLimits& limits, bool has_all_files, SceneElement* root,
                     Reading* reading);

}  // namespace smile::scene_xml
