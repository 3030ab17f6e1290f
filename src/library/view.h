#pragma once

#include <cstdint>

#include "scene/scene_spec.h"
#include "scene/visual_model.h"

namespace smile::library {

/// What people see at this moment: the simulation, or a recording that is shown.
struct View {
  const scene::VisualModel* model = nullptr;
  scene::VisualState state;
  std::uint64_t tick = 0;
  std::uint32_t scene = 0;                         ///< counts up whenever `model` is another one
  double meters_per_unit = scene::kMetersPerUnit;  ///< of the scene's file
};

}  // namespace smile::library
