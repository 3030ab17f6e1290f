#pragma once

#include <string>
#include <string_view>

#include "scene_import/foreign_world.h"
#include "scene_import/internal_model_files.h"
#include "scene_import/internal_source_element.h"

namespace smile::scene_import {

/// Reads a MJCF model, with what it includes.
/// @param root  its root element.
ForeignWorld ReadMjcf(const SourceElement& root, ModelFiles* files, ImportFindings* findings);

/// Reads the first world, or the models, of a SDFormat file.
ForeignWorld ReadSdf(const SourceElement& root, ModelFiles* files, ImportFindings* findings);

/// Reads a URDF: one tree of links. A root link named `world` is the world.
ForeignWorld ReadUrdf(const SourceElement& root, ModelFiles* files, ImportFindings* findings);

}  // namespace smile::scene_import
