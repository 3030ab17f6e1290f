#pragma once

#include <functional>

#include "physics/body.h"
#include "physics/joint.h"
#include "physics/snapshot.h"

// What may not be part of a World. All throw std::invalid_argument with what was found.

namespace smile::physics {

void CheckBody(const BodySpec& spec);

/// Both functions are to throw, of their own kind, when there is no such thing.
void CheckJoint(const JointSpec& spec, const std::function<bool(BodyId)>& is_static,
                const std::function<int(ArticulationId)>& num_links);

/// That ids are in order and used once, and that joints join what is there. `state` is not read.
void CheckSnapshot(const Snapshot& snapshot);

}  // namespace smile::physics
