#pragma once

#include <string>
#include <vector>

#include "scene/scene_spec.h"
#include "scene/solid.h"

namespace smile::scene {

/// Returns the controls of an object, itself or parts of it, in the order of the file.
/// Solid::control and Visual::choice use these indices.
std::vector<const Part*> ControlsOf(const Part& whole);

/// Returns `toggleSwitch`, `indicatorLights`, or the name of a custom control.
/// @throws std::logic_error if the part is no control.
std::string KindOf(const Part& control);
/// Returns the id of a switch's button in commands and pages: `ID-b1` for the left one, `ID-b2` for
/// the right one.
std::string ButtonId(const std::string& switch_id, Button button);
int NumStatesOf(const Part& control);
int InitialStateOf(const Part& control);
const std::vector<std::string>& DownstreamOf(const Part& control);

/// Returns the pieces that are present for given variants of the object's controls: a switch has
/// one variant per position, lights and custom controls have one per state.
/// @param variants  one per control of the object.
std::vector<Solid> SolidsWith(const std::vector<int>& variants, const std::vector<Solid>& solids);

}  // namespace smile::scene
