#pragma once

#include "scene/shape.h"

namespace smile::scene {

/// One of the lamps; its axis is **y**, as every cylinder's.
Cylinder DiscOf(const IndicatorLights& lights);

/// Where lamp `number` stands, its axis turned along the lights' z.
RigidTransform PoseOfLight(const IndicatorLights& lights, int number);

}  // namespace smile::scene
