#pragma once

#include "model/indices.h"
#include "scene/tool.h"

namespace smile::model {

/// Object of the scene that is a tool.
struct Tool {
  const scene::ToolSpec* spec = nullptr;  ///< in the scene; never null in a Model
  ObjectIndex object{0};
};

}  // namespace smile::model
