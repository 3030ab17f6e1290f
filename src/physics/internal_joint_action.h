#pragma once

#include "physics/internal_joint_set.h"
#include "physics/internal_world_objects.h"

// What joints do to bodies before a step; see docs/decisions/physics.md.

namespace smile::physics {

/// Gives each carried body the mass of all that hangs on it, so that a hand moves the whole of it;
/// wakes what hangs on it.
void LoadCarriedBodies(const WorldObjects& objects, const JointSet& joints);

/// Takes speed from damped and soft sliders, and holds those that stay where they are put.
void DampSliders(const WorldObjects& objects, const JointSet& joints, double step_seconds);

}  // namespace smile::physics
