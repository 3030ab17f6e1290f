#pragma once

#include "model/model.h"

namespace smile::model {

/// Returns the state of a scene at the start. Fastened guests are at their hosts, together with
/// everything joined to them.
/// @param model  complete except for its initial state.
SceneState InitialStateOf(const Model& model);

}  // namespace smile::model
