#pragma once

#include "base/index.h"

namespace smile::model {

/// Index of an object, in the order of the scene.
using ObjectIndex = Index<struct ObjectTag>;
/// Index of a control: by object, those of one object in the order of scene::ControlsOf().
using ControlIndex = Index<struct ControlTag>;
/// Indices of bond points: by object, those of one object in the order of scene::GuestsOf() and
/// scene::HostsOf().
using GuestIndex = Index<struct GuestTag>;
using HostIndex = Index<struct HostTag>;
/// Index of a tool, in the order of the scene.
using ToolIndex = Index<struct ToolTag>;
/// Index of a moving link of the robot, in the order of RobotModel::links.
using LinkIndex = Index<struct LinkTag>;
/// Index of a frame of the visual model, see scene::FramePoses.
using FrameIndex = Index<struct FrameTag>;
/// Index of a choice of the visual model, see scene::VisualState::variants.
using ChoiceIndex = Index<struct ChoiceTag>;

}  // namespace smile::model
