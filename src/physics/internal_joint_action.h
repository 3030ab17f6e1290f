#pragma once

#include "physics/internal_joint_set.h"
#include "physics/internal_world_objects.h"

// Actions of joints on bodies before a step; see docs/decisions/physics.md.

namespace smile::physics {

/// Gives each carried body the mass of everything joined to it, so that a hand moves the whole
/// group, and wakes the group.
void LoadCarriedBodies(const WorldObjects& objects, const JointSet& joints);

/// Slows damped and soft sliders by impulses, and holds sliders with damping 1 at their offsets.
void DampSliders(const WorldObjects& objects, const JointSet& joints, double step_seconds);

}  // namespace smile::physics
