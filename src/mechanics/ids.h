#pragma once

#include "base/strong_id.h"

namespace smile::mechanics {

/// Identifier of a body in one World. Ids count up from 1 in order of creation and are not used
/// twice, except that World::Restore() also restores the counter: ids made since the snapshot are
/// then void.
using BodyId = StrongId<struct BodyTag>;
using JointId = StrongId<struct JointTag>;
using ArticulationId = StrongId<struct ArticulationTag>;

}  // namespace smile::mechanics
