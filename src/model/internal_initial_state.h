#pragma once

#include "model/model.h"

namespace smile::model {

/// The state of a scene at the start. What is fastened from the start is where its host has it,
/// with all that is joined with it.
/// @param model  complete but for its initial state.
SceneState InitialStateOf(const Model& model);

}  // namespace smile::model
