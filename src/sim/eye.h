#pragma once

#include "model/eye.h"
#include "sim/simulation.h"

namespace smile::sim {

using model::Channels;
using model::Eye;
using model::EyeSpec;
using model::kEyeCamera;
using model::kHeadCamera;
using model::ViewSample;

/// Returns the present view of a camera; see model::EyeView().
CameraView EyeView(const Simulation& simulation, const EyeSpec& spec);
/// Returns the present state and view of a camera.
ViewSample ViewSampleOf(const Simulation& simulation, const EyeSpec& spec);

}  // namespace smile::sim
