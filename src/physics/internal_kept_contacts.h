#pragma once

#include "physics/internal_bullet.h"

namespace smile::physics {

/// Finds the contacts of two objects whose boxes overlap; for btCollisionDispatcher, in place of
/// Bullet's own way (WorldConfig::has_firm_contacts).
///
/// Two bodies of which one stands firmly on the other keep the contact points that they have.
/// Bullet finds the points again in each step. Where edges lie on each other, rounding decides
/// which corner is found, the points and their impulses change, and a high stack never comes to an
/// exact rest. It also costs most of the time of bodies with many parts.
void KeepOrCollide(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                   const btDispatcherInfo& info);

}  // namespace smile::physics
