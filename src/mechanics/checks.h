#pragma once

#include <functional>

#include "mechanics/body_spec.h"
#include "mechanics/joint.h"
#include "mechanics/snapshot.h"

// Checks of what becomes part of a World. All throw std::invalid_argument with what was found.

namespace smile::mechanics {

/// Checks a body's definition.
/// @throws std::invalid_argument if a number is not finite or out of range.
void CheckBody(const BodySpec& spec);

/// Checks the tree and the numbers of an articulation that comes from a snapshot.
/// @throws std::invalid_argument if a link has no sound parent or leader, or a number is not
/// finite.
void CheckArticulation(const scene::ArticulationSpec& spec);

/// Checks a joint: numbers, existing bodies and links. The two functions throw, each in its own
/// way, if their argument does not exist.
/// @throws std::invalid_argument if the joint is not possible.
void CheckJoint(const JointSpec& spec, const std::function<bool(BodyId)>& is_static,
                const std::function<int(ArticulationId)>& num_links);

/// Checks that ids are in order and used once, and that joints refer to existing bodies and links.
/// Does not read states, nor the definitions of bodies and articulations, which most of the time a
/// world has already.
/// @param known  bodies of a sound snapshot: of those, only what was set since is checked.
/// @throws std::invalid_argument if not.
void CheckSnapshot(const Snapshot& snapshot, const SharedList<Snapshot::BodyEntry>& known = {});

}  // namespace smile::mechanics
