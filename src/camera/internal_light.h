#pragma once

#include "math/rigid_transform.h"
#include "scene/lighting.h"

namespace smile::camera::internal {

/// Returns the factors of red, green and blue; all 1 in the usual light.
Vector3 LightColor(const scene::Lighting& lighting);

/// Returns the direction towards the lamp of the presentation style; unit length.
Vector3 DirectionToLamp(const scene::Lighting& lighting);

}  // namespace smile::camera::internal
