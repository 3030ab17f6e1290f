#pragma once

#include "scene/shape.h"

namespace smile::scene {

/// Returns the disc of one lamp; its axis is **y**, as for every cylinder.
Cylinder DiscOf(const IndicatorLights& lights);

/// Returns the pose of lamp `number`, whose axis is the lights' z.
RigidTransform PoseOfLight(const IndicatorLights& lights, int number);

}  // namespace smile::scene
