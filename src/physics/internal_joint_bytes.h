#pragma once

#include "base/bytes.h"
#include "physics/joint.h"

namespace smile::physics {

/// All that a joint is, as it stands in a serialized snapshot.
void PutJoint(const Joint& joint, ByteWriter* out);

}  // namespace smile::physics
