#pragma once

#include <string>
#include <vector>

#include "scene/scene_spec.h"
#include "scene/solid.h"

namespace smile::scene {

/// The controls of an object, itself or parts of it, in the order of the file. Solid::control and
/// Visual::choice number them so.
std::vector<const Part*> ControlsOf(const Part& whole);

/// `toggleSwitch`, `indicatorLights`, or the name a custom control has been given.
/// @throws std::logic_error if the part is no control.
std::string KindOf(const Part& control);
/// The name that commands and pages have for a button of a switch: `ID-b1` for the left one,
/// `ID-b2` for the right one.
std::string ButtonId(const std::string& switch_id, Button button);
int NumStatesOf(const Part& control);
int InitialStateOf(const Part& control);
const std::vector<std::string>& DownstreamOf(const Part& control);

/// The pieces that are there while the object's controls look so: a switch looks like its position,
/// lights and custom controls like their state.
/// @param looks  one per control of the object.
std::vector<Solid> SolidsWith(const std::vector<int>& looks, const std::vector<Solid>& solids);

}  // namespace smile::scene
