#pragma once

#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/scene_limits.h"

namespace smile::scene_xml {

/// Replaces each `instance` by the content of its template and each `$…$` expression in an
/// attribute below the root by its value. No `def`, `instance` or `var` remains; elements that
/// cannot be expanded are dropped, with a finding.
///
/// @param has_all_files  if false, a missing template may be in a missing file and is no finding.
void ExpandTemplates(const SceneLimits& limits, bool has_all_files, SceneElement* root,
                     ReadingContext* reading);

}  // namespace smile::scene_xml
