#pragma once

#include "math/rigid_transform.h"

namespace smile::motion {

/// What an arm holds, for the check of a motion: all of a box, in the frame of the tool [units].
struct HeldBox {
  Vector3 lower = Vector3::Zero(), upper = Vector3::Zero();  ///< opposite corners

  bool operator==(const HeldBox&) const = default;
};

}  // namespace smile::motion
