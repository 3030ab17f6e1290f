#pragma once

#include "demonstrator/engine.h"

namespace smile::demonstrator {

/// Limits of an invisible hand. Measured against five other ways of dragging (see
/// docs/decisions/physics.md): only limited force *and* limited speed neither pass through tables
/// nor blow up stacks.
struct ServoConfig {
  double response_seconds = 0.02;           ///< time constant with which it closes a small gap
  double max_speed = 1.0;                   ///< [m/s]
  double max_acceleration = 40.0;           ///< force per mass of the held object [m/s2]
  double max_angular_speed = 6.0;           ///< [rad/s]
  double max_angular_acceleration = 400.0;  ///< [rad/s2]
};

/// Drives a carried body towards a pose for one physics step: a velocity servo with limited change
/// of velocity, that is, limited force. Obstacles are pushed no harder than that.
///
/// @param speed  greatest speed [m/s]; the servo's own limit also applies.
void DriveTowards(const RigidTransform& X_WB_goal, double speed, const ServoConfig& config,
                  mechanics::BodyId body, Engine* engine);

}  // namespace smile::demonstrator
