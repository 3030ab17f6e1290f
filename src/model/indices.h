#pragma once

#include "base/index.h"

namespace smile::model {

/// Of the scene's objects, in the order of the scene.
using ObjectIndex = Index<struct ObjectTag>;
/// Of the scene's controls: by object, those of one object as scene::ControlsOf() has them.
using ControlIndex = Index<struct ControlTag>;
/// Of the scene's bond points: by object, those of one object as scene::GuestsOf() and
/// scene::HostsOf() have them.
using GuestIndex = Index<struct GuestTag>;
using HostIndex = Index<struct HostTag>;
/// Of the robot's moving links, in the order of RobotModel::links.
using LinkIndex = Index<struct LinkTag>;
/// Of the frames of the visual model, see scene::FramePoses.
using FrameIndex = Index<struct FrameTag>;
/// Of the choices of the visual model, see scene::VisualState::looks.
using ChoiceIndex = Index<struct ChoiceTag>;

}  // namespace smile::model
