#pragma once

#include <cstdint>

#include "scene/scene_spec.h"
#include "scene/visual_model.h"

namespace smile::library {

/// Displayed state of the simulation or of a recording.
struct DisplayedState {
  const scene::VisualModel* model = nullptr;
  scene::VisualState state;
  std::uint64_t tick = 0;
  std::uint32_t scene = 0;                         ///< increases whenever `model` changes
  double meters_per_unit = scene::kMetersPerUnit;  ///< of the scene's file
};

}  // namespace smile::library
