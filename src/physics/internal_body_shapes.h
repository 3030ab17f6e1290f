#pragma once

#include "physics/body.h"
#include "physics/internal_shapes.h"

namespace smile::physics {

struct Body::Shapes {
  CollisionShape collision;
};

}  // namespace smile::physics
