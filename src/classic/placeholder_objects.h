#pragma once

#include "classic/classic_reader.h"
#include "scene/scene_spec.h"

namespace smile::classic {

/// Returns a scene of placeholder objects for a classic recording without its own scene: a block
/// for every object, in the order of ClassicRecording::Objects(), where the object is first seen.
///
/// A block is as large as the descriptions `bboxx`, `bboxy` and `bboxz` specify, 1 unit by default;
/// has the color of its description `color`, else one of a palette; and has the descriptions of the
/// object's first creation. It has the object's id, with `_` for letters that a scene does not
/// allow.
/// @throws InputError if a size is not a length.
scene::SceneSpec MakePlaceholders(const ClassicRecording& recording);

}  // namespace smile::classic
