#pragma once

#include "interchange/exported_motion.h"
#include "interchange/exported_text.h"

namespace smile::interchange {

/// Returns a scene as the text form of OpenUSD (https://openusd.org), in meters with z up, with the
/// schemas of UsdPhysics: bodies, masses, colliders, friction, joints, and the robot as an
/// articulation with a drive for each motor.
///
/// In a recording, bodies and links are kinematic and have time samples, 60 time codes per second;
/// what appears and vanishes is visible or not. There are no joints then.
ExportedText ToUsd(const ExportedScene& scene);

}  // namespace smile::interchange
