#pragma once

#include <span>

#include "physics/definitions.h"
#include "physics/internal_world_objects.h"

// Queries for contacts and overlaps in a World. No query leaves a trace.

namespace smile::physics {

/// Returns the contacts of bodies with a link, by body. Contacts up to 0.1 mm apart count.
std::vector<LinkContact> FindContacts(const Articulation& articulation, int link,
                                      const WorldObjects& objects, Engine& engine);

/// See World::PushesOn().
std::vector<Push> FindPushes(std::span<const BodyId> ids, const WorldObjects& objects,
                             Engine& engine);

/// Returns the bodies that touch this one, by id: those up to 0.1 mm apart, and those that bounced
/// off it in the last step.
std::vector<BodyId> FindTouchingBodies(const Body& body, const WorldObjects& objects);

/// Returns the objects that a body would overlap by more than `depth` [m] if it stood at `X_WB`,
/// without those that it does not collide with. The body need not be one of `objects`.
Overlaps FindOverlaps(const Body& body, const RigidTransform& X_WB, double depth,
                      const WorldObjects& objects, Engine& engine);

}  // namespace smile::physics
