#pragma once

#include <optional>

#include "scene_import/foreign_world.h"
#include "scene_import/internal_model_files.h"
#include "scene_import/internal_sdf_frames.h"

namespace smile::scene_import {

/// Returns the mass of a link; nullopt if it is that of its shapes.
std::optional<ForeignMass> SdfMassOf(const SourceElement& link, SdfFrames* frames,
                                     ImportFindings* findings);

/// Adds the collisions and visuals of a link to its body; other content is remarked, except
/// sensors.
void ReadSdfShapes(const SourceElement& link, SdfFrames* frames, ModelFiles* files,
                   ForeignBody* body, ImportFindings* findings);

}  // namespace smile::scene_import
