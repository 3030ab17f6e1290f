#pragma once

#include "robot/internal_baxter_links.h"

namespace smile::robot::internal {

/// The face of a mood: flat pieces in layers on the display, eyes and brows that we drew.
/// @param X_LD  the middle of the display D: x to the right of who looks at it, y up, z towards
///              them. It is 0.224 m wide and 0.148 m high.
LinkLook FaceLook(Mood mood, const RigidTransform& X_LD);

}  // namespace smile::robot::internal
