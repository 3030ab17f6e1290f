#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "scene/scene_spec.h"
#include "sim/simulation.h"

namespace smile::studio {

/// What is on the table now, as a scene to begin anew with: objects where they are, sliders,
/// controls and bonds as they are. What was destroyed or fell to the floor is not in it. Strings
/// hang as they did in the beginning; speeds are lost.
/// @throws RequestError if a part of a string is gone: a scene has whole strings only.
scene::SceneSpec PresentScene(const sim::Simulation& simulation);

/// The scene without some of its objects, and without all that names them. Of a slider or string
/// that loses a piece the rest is no longer joined; what is left of a string is taken away, too.
scene::SceneSpec Without(scene::SceneSpec scene,
                         const std::function<bool(const scene::ObjectSpec&)>& is_taken);

/// What hands and robot were doing, as commands for a simulation that begins anew: what hands
/// held, they take again, and the robot stands as it stood.
std::vector<sim::Command> WhatGoesOn(const sim::Simulation& simulation);

/// All ids in a scene: of objects, parts, controls and bond points.
std::set<std::string> IdsOf(const scene::SceneSpec& scene);

}  // namespace smile::studio
