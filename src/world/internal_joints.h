#pragma once

#include <vector>

#include "physics/world.h"
#include "scene/scene_spec.h"
#include "world/object.h"

namespace smile::world {

/// Add the ball joints of a chain and the rail of a slider between the bodies of the scene's
/// objects.
void AddChainJoints(const scene::ChainSpec& chain, double meters_per_unit,
                    const std::vector<Object>& objects, physics::World* world);
void AddSliderJoint(const scene::SliderSpec& slider, const std::vector<Object>& objects,
                    physics::World* world);

}  // namespace smile::world
