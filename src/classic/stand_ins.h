#pragma once

#include "classic/classic_reader.h"
#include "scene/scene_spec.h"

namespace smile::classic {

/// A scene for a classic recording whose own is not at hand: a block for every object, in the order
/// of ClassicRecording::Objects(), where the object is first seen.
///
/// A block is as large as the descriptions `bboxx`, `bboxy` and `bboxz` say, 1 unit where they say
/// nothing; has the color its description `color` names, else one of a palette; and the
/// descriptions the object was first created with. It has the object's id, as far as a scene may
/// have it: what is no letter, digit or `_` becomes `_`.
/// @throws InputError if a size is no length.
scene::SceneSpec MakeStandIns(const ClassicRecording& recording);

}  // namespace smile::classic
