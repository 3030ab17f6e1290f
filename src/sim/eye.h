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

/// Where a camera is now; see model::EyeView().
CameraView EyeView(const Simulation& simulation, const EyeSpec& spec);
/// The present moment, as a camera sees it.
ViewSample ViewSampleOf(const Simulation& simulation, const EyeSpec& spec);

}  // namespace smile::sim
